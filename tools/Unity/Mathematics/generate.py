"""Writes Generated/: the vector types, the matrices and math's functions on them, one pattern for all element types.

Run it after a change here:  python3 tools/Unity/Mathematics/generate.py
"""
import itertools
import pathlib

FOLDER = pathlib.Path(__file__).parent / "Generated"
AXES = "xyzw"
INLINE = "[MethodImpl(AggressiveInlining)] "
SUFFIX = {"int": "", "uint": "", "float": "f", "double": ""}
# Element types that convert to the key: without a cast, with one.
IMPLICIT = {"float": ["int", "uint"], "double": ["int", "uint", "float"], "int": [], "uint": [], "bool": []}
EXPLICIT = {"float": ["bool", "double"], "double": ["bool"], "int": ["bool", "uint", "float", "double"],
            "uint": ["bool", "int", "float", "double"], "bool": []}
# What a file needs of the framework, by the words that need it.
USINGS = {"System": ("Serializable", "Exception"), "System.Runtime.CompilerServices": ("MethodImpl(",), "System.Runtime.InteropServices": ("MarshalAs",),
          "static System.Runtime.CompilerServices.MethodImplOptions": ("MethodImpl(",)}


def write(name, kind, lines):
    body = kind + "\n{\n" + "\n".join("    " + line if line else "" for line in lines) + "\n}\n"
    usings = "".join(f"using {u};\n" for u, words in USINGS.items() if any(word in body for word in words))
    head = "// Written by generate.py.\n" + usings + ("\n" if usings else "")
    FOLDER.joinpath(name + ".cs").write_text(f"{head}namespace Unity.Mathematics;\n\n{body}")


def each(n, pattern, separator=", "):
    """The pattern once per component: @ stands for its name."""
    return separator.join(pattern.replace("@", a) for a in AXES[:n])


def fold(names):
    """A hash that is the same in every process, unlike HashCode's."""
    return " ^ ".join(f"({name}.GetHashCode() * {factor})" for name, factor in zip(names, (73856093, 19349663, 83492791, 49979687)))


def cast(to, source, value):
    if source == "bool":
        one = {"float": "1f", "double": "1.0", "int": "1", "uint": "1u"}[to]
        zero = {"float": "0f", "double": "0.0", "int": "0", "uint": "0u"}[to]
        return f"{value} ? {one} : {zero}"
    return value if source in IMPLICIT[to] or source == to else f"({to}){value}"


def partitions(n):
    """Ways to put n components together from scalars and shorter vectors, in order."""
    if n == 0:
        yield []
    for size in range(1, n + 1):
        for rest in partitions(n - size):
            yield [size] + rest


def constructors(t, n):
    """(parameter list, value of each component) of every constructor."""
    for sizes in partitions(n):
        parameters, values, at = [], [], 0
        for size in sizes:
            name = AXES[at:at + size]
            parameters.append(f"{t if size == 1 else t + str(size)} {name}")
            values += [name] if size == 1 else [f"{name}.{AXES[i]}" for i in range(size)]
            at += size
        yield ", ".join(parameters), values
    yield f"{t} v", ["v"] * n
    for source in (["bool", "int", "uint", "float", "double"] if t != "bool" else []):
        if source != t:
            yield f"{source} v", [cast(t, source, "v")] * n
            yield f"{source}{n} v", [cast(t, source, "v." + a) for a in AXES[:n]]


def operators(t, v, n):
    same, boolean = v, f"bool{n}"
    if t == "bool":
        groups = [("== !=", boolean), ("& | ^", same)]
    else:
        groups = [("+ - * / %", same), ("< <= > >= == !=", boolean)]
        if t in ("int", "uint"):
            groups.append(("& | ^", same))
    for symbols, result in groups:
        for op in symbols.split():
            for left, right in ((v, v), (v, t), (t, v)):
                a = "lhs.@" if left == v else "lhs"
                b = "rhs.@" if right == v else "rhs"
                yield f"{INLINE}public static {result} operator {op}({left} lhs, {right} rhs) => new({each(n, f'{a} {op} {b}')});"
    if t == "bool":
        yield f"{INLINE}public static {v} operator !({v} val) => new({each(n, '!val.@')});"
        return
    minus = "(uint)-val.@" if t == "uint" else "-val.@"
    yield f"{INLINE}public static {v} operator -({v} val) => new({each(n, minus)});"
    yield f"{INLINE}public static {v} operator +({v} val) => val;"
    yield f"{INLINE}public static {v} operator ++({v} val) => new({each(n, 'val.@ + 1')});"
    yield f"{INLINE}public static {v} operator --({v} val) => new({each(n, 'val.@ - 1')});"
    if t in ("int", "uint"):
        yield f"{INLINE}public static {v} operator ~({v} val) => new({each(n, '~val.@')});"
        yield f"{INLINE}public static {v} operator <<({v} x, int n) => new({each(n, 'x.@ << n')});"
        yield f"{INLINE}public static {v} operator >>({v} x, int n) => new({each(n, 'x.@ >> n')});"


def vector(t, n):
    v = f"{t}{n}"
    field = "[MarshalAs(UnmanagedType.U1)] public" if t == "bool" else "public"
    lines = [f"{field} {t} {a};" for a in AXES[:n]]
    lines += [f"public static readonly {v} zero;", ""] if t != "bool" else [""]
    for parameters, values in constructors(t, n):
        body = " ".join(f"this.{a} = {value};" for a, value in zip(AXES, values))
        lines.append(f"{INLINE}public {v}({parameters}) {{ {body} }}")
    lines += ["", f"public unsafe {t} this[int index]", "{",
              f"    {INLINE}get {{ fixed ({v}* p = &this) return (({t}*)p)[Checked(index)]; }}",
              f"    {INLINE}set {{ fixed ({v}* p = &this) (({t}*)p)[Checked(index)] = value; }}", "}", ""]
    lines.append(f"{INLINE}public static implicit operator {v}({t} v) => new(v);")
    for mode, sources in (("implicit", IMPLICIT[t]), ("explicit", EXPLICIT[t])):
        for source in sources:
            lines.append(f"{INLINE}public static {mode} operator {v}({source} v) => new(v);")
            lines.append(f"{INLINE}public static {mode} operator {v}({source}{n} v) => new(v);")
    lines += list(operators(t, v, n)) + [""]
    lines.append(f"{INLINE}public bool Equals({v} rhs) => {each(n, '@ == rhs.@', ' && ')};")
    lines.append(f"public override bool Equals(object o) => o is {v} other && Equals(other);")
    lines.append(f"public override int GetHashCode() => {fold(AXES[:n])};")
    if t == "bool":
        lines.append(f'public override string ToString() => $"{v}({each(n, "{@}")})";')
    else:
        text = each(n, "{@.ToString(format, formatProvider)}" + SUFFIX[t])
        lines += ["public override string ToString() => ToString(null, null);",
                  f'public string ToString(string format, IFormatProvider formatProvider) => $"{v}({text})";']
    lines += ["", INLINE.strip(), "static int Checked(int index)", "{", f"    if ((uint)index >= {n})",
              f'        throw new ArgumentException("index must be between[0...{n - 1}]");', "    return index;", "}"]
    interfaces = f"IEquatable<{v}>" + ("" if t == "bool" else ", IFormattable")
    write(v, f"[Serializable]\npublic partial struct {v} : {interfaces}", lines)


def swizzles(t, n):
    lines = []
    for size in (2, 3):
        for letters in itertools.product(AXES[:n], repeat=size):
            name, value = "".join(letters), ", ".join(letters)
            getter = f"{INLINE}get => new({value});"
            setter = ""
            if len(set(letters)) == size:
                setter = f" {INLINE}set {{ " + " ".join(f"{a} = value.{b};" for a, b in zip(letters, AXES)) + " }"
            lines.append(f"public {t}{size} {name} {{ {getter}{setter} }}")
    write(f"{t}{n}.Swizzles", f"public partial struct {t}{n}", lines)


REAL_UNARY = ("abs saturate tan tanh atan cos cosh acos sin sinh asin floor ceil round trunc frac rcp sign exp exp2 exp10 "
              "log log2 log10 sqrt rsqrt radians degrees square").split()
REAL_MANY = ["min(x y)", "max(x y)", "atan2(y x)", "pow(x y)", "fmod(x y)", "step(threshold x)", "lerp(start end t)", "unlerp(start end x)",
             "remap(srcStart srcEnd dstStart dstEnd x)", "mad(mulA mulB addC)", "clamp(valueToClamp lowerBound upperBound)", "smoothstep(xMin xMax x)"]
WHOLE_MANY = ["min(x y)", "max(x y)", "mad(mulA mulB addC)", "clamp(valueToClamp lowerBound upperBound)"]


def componentwise(v, n, function, result=None):
    name, names = function.rstrip(")").split("(")
    names = names.split()
    parameters = ", ".join(f"{v} {p}" for p in names)
    calls = each(n, f"{name}({', '.join(p + '.@' for p in names)})")
    return f"{INLINE}public static {result or v} {name}({parameters}) => new {result or v}({calls});"


def functions(t, n):
    v = f"{t}{n}"
    lines = [f"{INLINE}public static {v} {v}({p}) => new {v}({', '.join(values)});" for p, values in constructors(t, n)] + [""]
    yes = "x.@" if t == "bool" else "x.@ != 0"
    lines.append(f"{INLINE}public static bool any({v} x) => {each(n, yes, ' || ')};")
    lines.append(f"{INLINE}public static bool all({v} x) => {each(n, yes, ' && ')};")
    if t == "bool":
        write(f"math.{v}", "public static partial class math", lines)
        return
    real = t in ("float", "double")
    unary = REAL_UNARY if real else ["square"] + (["abs", "sign"] if t == "int" else [])
    lines += [componentwise(v, n, f"{name}(x)") for name in unary]
    lines += [componentwise(v, n, f) for f in (REAL_MANY if real else WHOLE_MANY)]
    lines += [componentwise(v, n, "select(falseValue trueValue test)").replace(f"{v} test", f"bool{n} test"),
              f"{INLINE}public static {v} select({v} falseValue, {v} trueValue, bool test) => test ? trueValue : falseValue;"]
    total = "(x.x + x.y) + (x.z + x.w)" if n == 4 else each(n, "x.@", " + ")
    nest = lambda f: {2: f"{f}(x.x, x.y)", 3: f"{f}({f}(x.x, x.y), x.z)", 4: f"{f}({f}(x.x, x.y), {f}(x.z, x.w))"}[n]
    lines += [f"{INLINE}public static {t} csum({v} x) => {total};",
              f"{INLINE}public static {t} cmin({v} x) => {nest('min')};",
              f"{INLINE}public static {t} cmax({v} x) => {nest('max')};",
              f"{INLINE}public static {t} dot({v} x, {v} y) => {each(n, 'x.@ * y.@', ' + ')};",
              f"{INLINE}public static {t} mul({v} a, {v} b) => dot(a, b);"]
    if real:
        lines += real_functions(t, v, n)
    else:
        lines += [componentwise(v, n, f) for f in ("ceilpow2(x)",)]
        lines += [componentwise(v, n, "ispow2(x)", f"bool{n}"), componentwise(v, n, "countbits(x)", f"int{n}"),
                  componentwise(v, n, "asfloat(x)", f"float{n}")]
        lines.append(componentwise(v, n, "asuint(x)", f"uint{n}") if t == "int" else componentwise(v, n, "asint(x)", f"int{n}"))
    write(f"math.{v}", "public static partial class math", lines)


def real_functions(t, v, n):
    small = "FLT_MIN_NORMAL" if t == "float" else "DBL_MIN_NORMAL"
    one, two = ("1f", "2f") if t == "float" else ("1.0", "2.0")
    lines = [componentwise(v, n, f"{f}(x)", f"bool{n}") for f in ("isfinite", "isinf", "isnan")]
    if t == "float":
        lines += [componentwise(v, n, "asint(x)", f"int{n}"), componentwise(v, n, "asuint(x)", f"uint{n}"), componentwise(v, n, "chgsign(x y)")]
    lines += [
        f"{INLINE}public static {v} lerp({v} start, {v} end, {t} t) => start + t * (end - start);",
        f"{INLINE}public static {t} lengthsq({v} x) => dot(x, x);",
        f"{INLINE}public static {t} length({v} x) => sqrt(dot(x, x));",
        f"{INLINE}public static {t} distance({v} x, {v} y) => length(y - x);",
        f"{INLINE}public static {t} distancesq({v} x, {v} y) => lengthsq(y - x);",
        f"{INLINE}public static {v} normalize({v} x) => rsqrt(dot(x, x)) * x;",
        f"{INLINE}public static {v} reflect({v} i, {v} n) => i - {two} * n * dot(i, n);",
        f"{INLINE}public static {v} project({v} a, {v} ontoB) => (dot(a, ontoB) / dot(ontoB, ontoB)) * ontoB;",
        f"{INLINE}public static {v} faceforward({v} n, {v} i, {v} ng) => select(n, -n, dot(ng, i) >= 0);",
        "",
        f"public static {v} normalizesafe({v} x, {v} defaultvalue = default)", "{", f"    {t} square = dot(x, x);",
        f"    return square > {small} ? x * rsqrt(square) : defaultvalue;", "}", "",
        f"public static {v} projectsafe({v} a, {v} ontoB, {v} defaultValue = default)", "{", f"    {v} projection = project(a, ontoB);",
        "    return all(isfinite(projection)) ? projection : defaultValue;", "}", "",
        f"public static {v} refract({v} i, {v} n, {t} indexOfRefraction)", "{", f"    {t} cosine = dot(n, i);",
        f"    {t} square = {one} - indexOfRefraction * indexOfRefraction * ({one} - cosine * cosine);",
        f"    return square >= 0 ? indexOfRefraction * i - (indexOfRefraction * cosine + sqrt(square)) * n : new {v}(0);", "}", "",
        f"public static {v} modf({v} x, out {v} i)", "{", "    i = trunc(x);", "    return x - i;", "}", "",
        f"public static void sincos({v} x, out {v} s, out {v} c)", "{", "    s = sin(x);", "    c = cos(x);", "}",
    ]
    if n == 3:
        lines += ["", INLINE.strip(), f"public static {v} cross({v} x, {v} y)", "{",
                  f"    return new {v}(x.y * y.z - x.z * y.y, x.z * y.x - x.x * y.z, x.x * y.y - x.y * y.x);", "}", "",
                  "/// <summary>Two unit vectors that complete a unit normal.</summary>",
                  f"public static void orthonormal_basis({v} normal, out {v} basis1, out {v} basis2)", "{",
                  f"    {t} side = normal.z >= 0 ? 1 : -1;", f"    {t} a = -1 / (side + normal.z);", f"    {t} b = normal.x * normal.y * a;",
                  f"    basis1 = new {v}(1 + side * normal.x * normal.x * a, side * b, -side * normal.x);",
                  f"    basis2 = new {v}(b, side + normal.y * normal.y * a, -normal.y);", "}"]
    return lines


def matrix(t, n):
    m, v, suffix = f"{t}{n}x{n}", f"{t}{n}", SUFFIX[t]
    columns = [f"c{i}" for i in range(n)]
    cells = [f"m{row}{column}" for row in range(n) for column in range(n)]
    def column(i): return f"new {v}({', '.join(f'm{row}{i}' for row in range(n))})"
    unit = ", ".join("1" if row == col else "0" for row in range(n) for col in range(n))
    assign = lambda values: "; ".join(f"this.{c} = {value}" for c, value in zip(columns, values)) + ";"
    per = lambda pattern: ", ".join(pattern.replace("@", c) for c in columns)
    lines = [f"public {v} {c};" for c in columns]
    lines += [f"public static readonly {m} identity = new({unit});", f"public static readonly {m} zero;", "",
              f"public {m}({', '.join(f'{v} {c}' for c in columns)}) {{ {assign(columns)} }}",
              f"public {m}({', '.join(f'{t} {c}' for c in cells)}) {{ {assign([column(i) for i in range(n)])} }}",
              f"public {m}({t} v) {{ {assign(['v'] * n)} }}", "",
              f"public unsafe ref {v} this[int index]", "{", "    get", "    {", f"        if ((uint)index >= {n})",
              f'            throw new ArgumentException("index must be between[0...{n - 1}]");',
              f"        fixed ({m}* p = &this) return ref (({v}*)p)[index];", "    }", "}", "",
              f"public static implicit operator {m}({t} v) => new(v);"]
    for op in "+-*/":
        lines += [f"public static {m} operator {op}({m} lhs, {m} rhs) => new({per(f'lhs.@ {op} rhs.@')});",
                  f"public static {m} operator {op}({m} lhs, {t} rhs) => new({per(f'lhs.@ {op} rhs')});",
                  f"public static {m} operator {op}({t} lhs, {m} rhs) => new({per(f'lhs {op} rhs.@')});"]
    rows = ",  ".join(", ".join(f"{{c{col}.{AXES[row]}.ToString(format, formatProvider)}}{suffix}" for col in range(n)) for row in range(n))
    lines += [f"public static {m} operator -({m} val) => new({per('-val.@')});", "",
              f"public bool Equals({m} rhs) => {' && '.join(f'{c}.Equals(rhs.{c})' for c in columns)};",
              f"public override bool Equals(object o) => o is {m} other && Equals(other);",
              f"public override int GetHashCode() => {fold(columns)};",
              "public override string ToString() => ToString(null, null);", "",
              "public string ToString(string format, IFormatProvider formatProvider)", "{", f'    return $"{m}({rows})";', "}"]
    write(m, f"[Serializable]\npublic partial struct {m} : IEquatable<{m}>, IFormattable", lines)

    row = lambda i: f"new {v}({', '.join(f'v.c{j}.{AXES[i]}' for j in range(n))})"
    lines = [f"public static {m} {m}({', '.join(f'{v} {c}' for c in columns)}) => new {m}({', '.join(columns)});",
             f"public static {m} {m}({t} v) => new {m}(v);", "",
             f"public static {m} {m}({', '.join(f'{t} {c}' for c in cells)})", "{", f"    return new {m}({', '.join(cells)});", "}", "",
             f"public static {v} mul({m} a, {v} b) => {' + '.join(f'a.c{i} * b.{AXES[i]}' for i in range(n))};",
             f"public static {v} mul({v} a, {m} b) => new {v}({', '.join(f'dot(a, b.{c})' for c in columns)});",
             f"public static {m} mul({m} a, {m} b) => new {m}({', '.join(f'mul(a, b.{c})' for c in columns)});",
             f"public static {m} transpose({m} v) => new {m}({', '.join(row(i) for i in range(n))});", ""]
    lines += inverse3(t, m, v) if n == 3 else inverse4(t, m, v)
    write(f"math.{m}", "public static partial class math", lines)


def inverse3(t, m, v):
    return [f"public static {t} determinant({m} m) => dot(m.c0, cross(m.c1, m.c2));", "",
            f"public static {m} inverse({m} m)", "{",
            f"    {v} row0 = cross(m.c1, m.c2), row1 = cross(m.c2, m.c0), row2 = cross(m.c0, m.c1);",
            f"    return transpose(new {m}(row0, row1, row2)) * (1 / dot(m.c0, row0));", "}"]


def inverse4(t, m, v):
    """By the 2x2 minors of the upper and the lower two rows."""
    lines = [f"public static {t}3 rotate({m} a, {t}3 b) => (a.c0 * b.x + a.c1 * b.y + a.c2 * b.z).xyz;",
             f"public static {t}3 transform({m} a, {t}3 b) => (a.c0 * b.x + a.c1 * b.y + a.c2 * b.z + a.c3).xyz;", "",
             f"public static {t} determinant({m} m)", "{", "    Minors(m, out var s, out var t, out var c, out var d);",
             "    return dot(s, new " + t + "3(d.z, -d.y, d.x)) + dot(t, new " + t + "3(c.z, -c.y, c.x));", "}", "",
             f"public static {m} inverse({m} m)", "{", "    Minors(m, out var s, out var t, out var c, out var d);",
             f"    {t} scale = 1 / determinant(m);"]
    # s = upper minors of columns 01 02 03, t = 12 13 23; c, d likewise of the lower rows.
    u = {"01": "s.x", "02": "s.y", "03": "s.z", "12": "t.x", "13": "t.y", "23": "t.z"}
    l = {"01": "c.x", "02": "c.y", "03": "c.z", "12": "d.x", "13": "d.y", "23": "d.z"}
    cell = lambda r, k: f"m.c{k}.{AXES[r]}"
    columns = []
    for row in range(4):  # column `row` of the inverse: cofactors of that row
        entries = []
        for k in range(4):
            rest = [j for j in range(4) if j != k]
            partner = {0: 1, 1: 0, 2: 3, 3: 2}[row]
            minors = l if row < 2 else u
            sign = -1 if (row + k) % 2 else 1
            terms = []
            for position, j in enumerate(rest):
                pair = "".join(str(x) for x in rest if x != j)
                positive = (position % 2 == 0) == (sign > 0)
                terms.append(("+ " if positive else "- ") + f"{cell(partner, j)} * {minors[pair]}")
            text = " ".join(terms)
            entries.append(text[2:] if text.startswith("+ ") else "-" + text[2:])
        columns.append(entries)
    lines.append(f"    return new {m}(")
    for index, entries in enumerate(columns):
        lines.append(f"        new {v}(")
        lines += [f"            {e}{',' if i < 3 else ')' + (',' if index < 3 else ') * scale;')}" for i, e in enumerate(entries)]
    lines += ["}", "", "/// <summary>Of a rotation and a translation, nothing else.</summary>", f"public static {m} fastinverse({m} m)", "{",
              f"    var turn = transpose(new {t}3x3(m.c0.xyz, m.c1.xyz, m.c2.xyz));",
              f"    return new {m}(new {v}(turn.c0, 0), new {v}(turn.c1, 0), new {v}(turn.c2, 0), new {v}(-mul(turn, m.c3.xyz), 1));", "}", "",
              "// Minors of the upper two rows (s, t) and the lower two (c, d), of columns 01, 02, 03 and 12, 13, 23.",
              f"static void Minors(in {m} m, out {t}3 s, out {t}3 t, out {t}3 c, out {t}3 d)", "{"]
    for target, row, pairs in (("s", 0, "01 02 03"), ("t", 0, "12 13 23"), ("c", 2, "01 02 03"), ("d", 2, "12 13 23")):
        minors = [f"{cell(row, int(p[0]))} * {cell(row + 1, int(p[1]))} - {cell(row, int(p[1]))} * {cell(row + 1, int(p[0]))}" for p in pairs.split()]
        lines += [f"    {target} = new {t}3("] + [f"        {e}{',' if i < 2 else ');'}" for i, e in enumerate(minors)]
    return lines + ["}"]


FOLDER.mkdir(exist_ok=True)
for old in FOLDER.glob("*.cs"):
    old.unlink()
for element in ("bool", "int", "uint", "float", "double"):
    for count in (2, 3, 4):
        vector(element, count)
        swizzles(element, count)
        functions(element, count)
for count in (3, 4):
    matrix("float", count)
