"""What Yosys's netlists take, and their longest paths: resources.csv and timing.csv of scripts/synthesize.sh.

netlist_figures.py NETLISTS ORDER RESOURCES TIMING: ORDER has a line "unit,configuration" for each netlist.

A path's delay is the sum of those of its cells, each with the net in front of it. Delays are estimates for a -2 device of
the UltraScale+ family, low, typical and high: docs/hardware.md says where they come from. There is no placement.
"""
import collections
import json
import sys

# LUTs of a primitive that is no plain LUT: shift registers and distributed RAM.
LUTS_OF = {"SRL16E": 1, "SRLC32E": 1, "RAM32X1S": 1, "RAM64X1S": 1, "RAM32X1D": 2, "RAM64X1D": 2, "RAM128X1S": 2,
           "RAM128X1D": 4, "RAM256X1S": 4, "RAM256X1D": 8, "RAM32M": 4, "RAM64M": 4, "RAM32M16": 8, "RAM64M8": 8,
           "RAM512X1S": 8}
FLIP_FLOPS = {"FDRE", "FDSE", "FDCE", "FDPE"}
BLOCK_RAMS = {"RAMB36E2": 1.0, "RAMB18E2": 0.5}
# [ns] low, typical, high
BEGIN = {"ff": (0.10, 0.12, 0.15), "bram": (0.75, 0.90, 1.15), "srl": (0.40, 0.50, 0.65)}  # clock to output, and setup
LUT = (0.20, 0.40, 0.70)  # with its net
MUX = (0.05, 0.08, 0.12)  # MUXF7 to MUXF9
CHAIN = (0.10, 0.15, 0.25)  # into a carry chain, and out of it
CARRY = (0.01, 0.015, 0.02)  # through four bits of it
DSP = (2.20, 2.60, 3.20)  # a product without registers, with its net
BRAM_INPUT = (0.35, 0.55, 0.90)  # setup of an address or a word, with its net
# Delay lines: paths into them may be spread over the stages behind them. By instance, the default number of stages.
DELAY_LINES = {"command_line": 7, "fragment_depth_line": 7, "fragment_index_line": 7, "edge_token_line": 7,
               "fragment_line": 7, "address_line": 7, "token_line": 2, "depth_line": 4, "edge_line": 4, "pipeline": 40, "valid_line": 36,
               "output_line": 1, "sweep.tokens": 3}
# Where work begins that has several cycles, and how many. Ahead of a scan a triangle comes every third cycle, and leaves
# each register as many for what is behind it.
SETUP = {"rasterizer": {("v0", "v1", "v2"): 12},
         "lane_rasterizer": {("ahead.vertices_v0", "ahead.vertices_v1", "ahead.vertices_v2"): 3,
                             ("ahead.set_up.held",): 2}}


def total(cells, of):
    return sum(count * of(kind) for kind, count in cells.items())


def resources(module):
    cells = collections.Counter(cell["type"] for cell in module["cells"].values())
    lut = total(cells, lambda kind: 1 if kind.startswith("LUT") else LUTS_OF.get(kind, 0))
    ff = total(cells, lambda kind: kind in FLIP_FLOPS)
    dsp = total(cells, lambda kind: kind == "DSP48E2")
    ramb = total(cells, lambda kind: BLOCK_RAMS.get(kind, 0))
    return f"{lut},{ff},{dsp},{ramb:g}"


class Timing:
    """Longest paths of one netlist, from what is clocked to what is clocked. Inputs are taken to come from registers."""

    def __init__(self, module):
        self.names = self._names(module)
        self.into = collections.defaultdict(list)  # bit -> [(bit in front, delay, what)]
        self.begins = {}
        self.ends = []  # (bit, delay, name of the place, the delay line that it is)
        for port in module["ports"].values():
            if port["direction"] == "input":
                self.begins.update({bit: "ff" for bit in port["bits"]})
        for cell in module["cells"].values():
            self._add(cell)

    @staticmethod
    def _names(module):
        """Of each bit, all names that its source has for it, the shortest first."""
        names = collections.defaultdict(list)
        for name, net in module["netnames"].items():
            if not net.get("hide_name", 0):
                for bit in net["bits"]:
                    names[bit].append(name)
        return {bit: sorted(of_bit, key=lambda name: (len(name), name)) for bit, of_bit in names.items()}

    def name(self, bit):
        return self.names.get(bit, ["-"])[0]

    def line_of(self, bits):
        """The delay line whose nets these are, or none."""
        of_bits = [name for bit in bits for name in self.names.get(bit, [])]
        return next((line for line in DELAY_LINES if any(f".{line}." in f".{name}" for name in of_bits)), None)

    def _arcs(self, cell, inputs, outputs, delay, what):
        for output in outputs:
            for bit_out in cell["connections"].get(output, []):
                for name in inputs:
                    self.into[bit_out] += [(bit, delay, what) for bit in cell["connections"].get(name, [])
                                           if isinstance(bit, int)]

    def _end(self, cell, inputs, outputs, delay):
        connections = cell["connections"]
        bits = [bit for name in outputs for bit in connections.get(name, [])]
        place = next((self.name(bit) for bit in bits if self.name(bit) != "-"), "-")
        is_shifted = cell["type"].startswith("SRL")
        line = self.line_of(connections["D"] if is_shifted else [])
        if not is_shifted and any(".line.g_bit" in name for bit in bits for name in self.names.get(bit, [])):
            line = self.line_of(bits)
        for name in inputs:
            self.ends += [(bit, delay, place if line is None else line, line) for bit in connections.get(name, [])
                          if isinstance(bit, int)]

    def _add(self, cell):
        kind, connections = cell["type"], cell["connections"]
        if kind.startswith("LUT"):
            self._arcs(cell, [f"I{i}" for i in range(6)], ["O"], LUT, "lut")
        elif kind in ("INV", "IBUF", "OBUF", "BUFG"):
            self._arcs(cell, ["I"], ["O"], (0, 0, 0), "")
        elif kind.startswith("MUXF"):
            self._arcs(cell, ["I0", "I1", "S"], ["O"], MUX, "mux")
        elif kind == "CARRY4":
            self._carry(connections)
        elif kind in FLIP_FLOPS:
            self.begins.update({bit: "ff" for bit in connections["Q"]})
            self._end(cell, ["D", "CE", "R", "S"], ["Q"], (0, 0, 0))
        elif kind in LUTS_OF:
            self._memory_in_luts(cell)
        elif kind in BLOCK_RAMS:
            outputs = [name for name in connections if name.startswith(("DOUT", "CASDO"))]
            self.begins.update({bit: "bram" for name in outputs for bit in connections[name]})
            self._end(cell, [name for name in connections if name.startswith(("ADDR", "DIN", "EN", "WE"))], outputs,
                      BRAM_INPUT)
        elif kind == "DSP48E2":
            if int(cell["parameters"].get("PREG", "0"), 2):
                self.begins.update({bit: "ff" for name in ("P", "PCOUT") for bit in connections.get(name, [])})
                self._end(cell, ["A", "B", "C", "D", "PCIN"], ["P"], DSP)
            else:
                self._arcs(cell, ["A", "B", "C", "D", "PCIN"], ["P", "PCOUT"], DSP, "dsp")

    def _memory_in_luts(self, cell):
        """Shift registers, and distributed RAM that is read without a clock."""
        connections = cell["connections"]
        outputs = [name for name in connections if name in ("Q", "Q31", "O", "DPO", "SPO") or name.startswith("DO")]
        self.begins.update({bit: "srl" for name in outputs for bit in connections[name]})
        self._end(cell, [name for name in connections if name in ("D", "CE", "WE") or name.startswith("DI")], outputs,
                  (0, 0, 0))
        addresses = [name for name in connections if name == "A" or (name.startswith(("A", "DPRA")) and name[-1].isdigit())]
        self._arcs(cell, addresses, outputs, LUT, "lut")

    def _carry(self, connections):
        """Bit by bit, so that there are no loops that are none."""
        bit_of = lambda name, i: connections.get(name, [None] * 4)[i]
        for i in range(4):
            for source in ("S", "DI"):
                bit = bit_of(source, i)
                if isinstance(bit, int):
                    for j in range(i, 4):
                        if j > i or source == "S":
                            self.into[bit_of("O", j)].append((bit, CHAIN, "chain"))
                        self.into[bit_of("CO", j)].append((bit, CHAIN, "chain"))
            for source in ("CI", "CYINIT"):
                bit = bit_of(source, 0)
                if isinstance(bit, int):
                    self.into[bit_of("O", i)].append((bit, CHAIN, "carry"))
                    self.into[bit_of("CO", i)].append((bit, CARRY, "carry"))

    def _order(self):
        """Bits that ends depend on, each behind those in front of it."""
        order, state = [], {}
        for root in [end[0] for end in self.ends]:
            stack = [(root, False)]
            while stack:
                bit, is_done = stack.pop()
                if is_done:
                    order.append(bit)
                elif bit not in state:
                    state[bit] = True
                    stack.append((bit, True))
                    stack += [(before, False) for before, _, _ in self.into.get(bit, []) if before not in state]
        return order

    def _latest(self, allowed):
        """bit -> (typical, bit in front, delay, what): when it is there, coming from allowed beginnings only."""
        latest = {}
        for bit in self._order():
            if bit in self.begins and allowed(self.names.get(bit, [])):
                delay = BEGIN[self.begins[bit]]
                latest[bit] = (delay[1], None, delay, self.begins[bit])
            for before, delay, what in self.into.get(bit, []):
                if before in latest and (bit not in latest or latest[before][0] + delay[1] > latest[bit][0]):
                    latest[bit] = (latest[before][0] + delay[1], before, delay, what)
        return latest

    def worst(self, allowed_begin, allowed_end):
        """Of the paths from an allowed beginning to an allowed end: delays, counts of cells, both names; or none."""
        latest = self._latest(allowed_begin)
        ends = [(latest[bit][0] + delay[1], bit, delay, place) for bit, delay, place, line in self.ends
                if bit in latest and allowed_end(line)]
        if not ends:
            return None
        _, bit, delay, place = max(ends, key=lambda end: end[0])
        sums, cells = list(delay), collections.Counter()
        while bit is not None:
            _, before, delay, what = latest[bit]
            sums = [a + b for a, b in zip(sums, delay)]
            cells[what] += 1
            begin, bit = bit, before
        return sums, cells, self.name(begin), place


def paths(unit, module):
    """(kind, stages, path): `cycle` has to close in one, `stages` may be spread over so many."""
    timing = Timing(module)
    setups = SETUP.get(unit, {})
    is_setup = lambda names: any(name in places for name in names for places in setups)
    found = [("cycle", 1, timing.worst(lambda names: not is_setup(names), lambda line: line is None))]
    for name, stages in DELAY_LINES.items():
        found.append(("stages", stages + 1,
                      timing.worst(lambda names: not is_setup(names), lambda line, name=name: line == name)))
    for places, cycles in setups.items():
        found.append(("stages", cycles, timing.worst(
            lambda names, places=places: any(name in places for name in names), lambda line: line is None)))
    for kind, stages, path in found:
        if path is None or (kind == "stages" and path[0][1] < 3):
            continue
        sums, cells, begin, end = path
        yield (kind, stages, *(f"{value:.2f}" for value in sums), cells["dsp"], cells["lut"], cells["chain"],
               cells["carry"], cells["bram"], begin, end)


def main():
    folder, order, resources_file, timing_file = sys.argv[1:]
    with open(order, encoding="utf-8") as lines:
        points = lines.read().splitlines()
    with open(resources_file, "w", encoding="utf-8") as table, open(timing_file, "w", encoding="utf-8") as times:
        table.write("unit,configuration,lut,ff,dsp,ramb36\n")
        times.write("unit,configuration,path,stages,low_ns,typical_ns,high_ns,dsps,luts,chains,carries,block_rams,from,to\n")
        for point in points:
            unit = point.split(",")[0]
            with open(f"{folder}/{point}.json", encoding="utf-8") as netlist:
                module = json.load(netlist)["modules"]["unit"]
            table.write(f"{point},{resources(module)}\n")
            if not unit.startswith(("fifo", "check.", "delay_line")):
                for path in paths(unit, module):
                    times.write(f"{point},{','.join(str(value) for value in path)}\n")


if __name__ == "__main__":
    main()
