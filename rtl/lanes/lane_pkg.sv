// Types of a core that works on pixels of a row side by side, in lanes: what faster_pkg has none for.
package lane_pkg;
    localparam int LANES = 10;  // at most, of a scan or a sweep; and banks of a memory
    localparam int GROUP_BITS = 32 + LANES;
    localparam int REGION_BITS = 64;
    localparam int FULL_BITS = 1 + 32 + REGION_BITS;
    localparam int BOX_BITS = 1 + 5 * 16;
    localparam int ROW_BITS = 3 + 5 * 16;
    typedef logic [3:0] lanes_t;

    // Pixels of a row relative to the window, which they may lie outside of: bit k of the mask is column col + k. Without
    // a bit: the end of a sample, or a corner of its region.
    typedef struct packed {
        logic signed [15:0] row;
        logic signed [15:0] col;
        logic [LANES-1:0]   mask;
    } group_t;

    // The pixels that a sample has drawn lie in this box; (0, 0) and (-1, -1): there are none.
    typedef struct packed {
        logic signed [15:0] first_row;
        logic signed [15:0] first_col;
        logic signed [15:0] last_row;
        logic signed [15:0] last_col;
    } region_t;

    // Where an edge bounds a row; or it runs along the rows.
    typedef enum logic [1:0] {FROM_LEFT, FROM_RIGHT, FLAT} side_t;

    // Of a triangle, in pixels of the image: the scan starts in its first row.
    typedef struct packed {
        logic               is_drawn;
        logic signed [15:0] col_min;
        logic signed [15:0] col_max;
        logic signed [15:0] row_max;
        logic signed [15:0] start_row;
        logic signed [15:0] start_col;
    } box_t;

    // A row of a triangle relative to the window: covered columns, and first columns of their groups in the direction of
    // the scan.
    typedef struct packed {
        logic               is_empty;  // no column is covered
        logic               is_last;   // of the triangle
        logic               goes_right;
        logic signed [15:0] row;
        logic signed [15:0] first_col;
        logic signed [15:0] last_col;
        logic signed [15:0] first_group;
        logic signed [15:0] last_group;
    } row_t;

    // Rounded down.
    function automatic logic [15:0] divided(input logic [15:0] value, input lanes_t by);
`ifdef SYNTHESIS  // a step per bit, without carry chains: a constant makes little of it
        logic [4:0] rest, less;
        logic borrow;
        rest = '0;
        for (int b = 15; b >= 0; b = b - 1) begin
            rest = {rest[3:0], value[b]};
            borrow = 1'b0;
            for (int i = 0; i < 5; i = i + 1) begin
                less[i] = rest[i] ^ (i < 4 && by[i & 3]) ^ borrow;
                borrow = (!rest[i] && ((i < 4 && by[i & 3]) || borrow)) || (i < 4 && by[i & 3] && borrow);
            end
            divided[b] = !borrow;
            if (!borrow) rest = less;
        end
`else
        divided = value / {12'b0, by};
`endif
    endfunction

    // A buffer that is drawn.
    typedef struct packed {
        logic        number;
        logic [31:0] valid_raster;
        region_t     region;
    } full_t;
endpackage
