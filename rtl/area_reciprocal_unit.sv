// 1 / area of every triangle that is drawn: a pipeline that flushes, one step per cycle. A step takes an area if there
// is one, else a bubble; what it took leaves `stages` steps later. A result without room freezes the unit, bubbles and
// all. Areas of zero or less yield nothing. With an `interval` above 1 so many steps less one behind a drawn triangle's
// area take bubbles only. A unit that squeezes never freezes: an area begins once its result has a place, in a stage or
// in the FIFO behind, and is held until then.
module area_reciprocal_unit #(
    parameter int AREA_BITS = 36,
    parameter int RECIPROCAL_BITS = 64,
    // Stages of the divider itself, at most `stages`; 0: it divides at once, and the delay line carries the quotient
    parameter int DIVIDER_STAGES = 0,
    parameter int DIVIDER_INTERVAL = 1  // as `interval`; above 1 needs DIVIDER_STAGES
) (
    input  logic                        clock,
    input  logic                        reset,
    input  faster_pkg::stage_t          stages,
    input  faster_pkg::cycles_t         interval,
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
    faster_pkg::cycles_t busy;  // steps in which no area is taken
    localparam bit IS_NEVER_BUSY = DIVIDER_STAGES > 0 && DIVIDER_INTERVAL == 1;
    logic is_held;  // an area that has yet to begin
    logic [AREA_BITS-2:0] held;
    wire has_place = !squeezes || taken < capacity;
    wire waits = squeezes && is_held;
    wire takes = area_has_token && (IS_NEVER_BUSY || busy == '0) && !waits;
    wire begins = (waits || (takes && is_drawn)) && has_place;
    logic [RECIPROCAL_BITS-1:0] quotient;

    divider #(
        .DIVIDEND_BITS(RECIPROCAL_BITS),
        .DIVISOR_BITS (AREA_BITS - 1),
        .STAGES       (DIVIDER_STAGES),
        .INTERVAL     (DIVIDER_INTERVAL)
    ) divide (
        .clock, .advance, .begins, .dividend(RECIPROCAL_BITS'(1) << one),
        .divisor(waits ? held : area[AREA_BITS-2:0]), .quotient
    );
    delay_line valid_line (
        .clock, .advance, .stages, .in(begins), .out(leaves)
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
        else taken <= taken + 12'(begins && advance) - 12'(area_reciprocal_is_read);
        if (reset) busy <= '0;
        else if (advance) busy <= begins ? interval - 8'd1 : busy - 8'(busy != '0);
    end
    always_ff @(posedge clock) begin
        is_held <= !reset && squeezes && !begins && (waits || (takes && is_drawn));
        if (!waits) held <= area[AREA_BITS-2:0];
    end
endmodule
