// 1 / area of every triangle that is drawn: a pipeline that flushes, one step per cycle. A step takes an area if there
// is one, else a bubble; what it took leaves `stages` steps later. A result without room freezes the unit, bubbles and
// all. Areas of zero or less yield nothing.
module area_reciprocal_unit #(
    parameter int AREA_BITS = 36,
    parameter int RECIPROCAL_BITS = 64,
    // Stages of the divider itself, at most `stages`; 0: it divides at once, and the delay line carries the quotient
    parameter int DIVIDER_STAGES = 0
) (
    input  logic                        clock,
    input  logic                        reset,
    input  faster_pkg::stage_t          stages,
    input  logic                        squeezes,
    input  logic [11:0]                 capacity,                // of the FIFO behind it
    input  logic                        area_reciprocal_is_read,  // from that FIFO
    input  logic [5:0]                  one,  // the dividend is 2^one: area_reciprocal + 2 vertex_xy

    input  logic                        area_has_token,
    output logic                        area_read,
    input  logic signed [AREA_BITS-1:0] area,
    input  logic                        area_reciprocal_has_room,
    output logic                        area_reciprocal_write,
    output logic [RECIPROCAL_BITS-1:0]  area_reciprocal
);
    logic leaves;
    wire is_drawn = area > 0;
    wire advance = !reset && (!leaves || area_reciprocal_has_room);
    logic [11:0] taken;  // results in the unit and in the FIFO
    wire takes = area_has_token && (!squeezes || !is_drawn || taken < capacity);
    logic [RECIPROCAL_BITS-1:0] quotient;

    divider #(
        .DIVIDEND_BITS(RECIPROCAL_BITS),
        .DIVISOR_BITS (AREA_BITS - 1),
        .STAGES       (DIVIDER_STAGES)
    ) divide (
        .clock, .advance, .dividend(RECIPROCAL_BITS'(1) << one), .divisor(area[AREA_BITS-2:0]), .quotient
    );
    delay_line valid_line (
        .clock, .advance, .stages, .in(takes && is_drawn), .out(leaves)
    );
    delay_line #(
        .BITS(RECIPROCAL_BITS)
    ) quotient_line (
        .clock, .advance, .stages(stages - 6'(DIVIDER_STAGES)), .in(quotient), .out(area_reciprocal)
    );

    assign area_read = takes && advance;
    assign area_reciprocal_write = leaves && area_reciprocal_has_room;

    always_ff @(posedge clock) begin
        if (reset) taken <= '0;
        else taken <= taken + 12'(area_read && is_drawn) - 12'(area_reciprocal_is_read);
    end
endmodule
