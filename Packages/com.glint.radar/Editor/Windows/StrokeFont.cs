using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>
    /// Letters as lines, for pictures that are drawn without Unity's text: ASCII and a few more. A character that is
    /// not among them is a box.
    /// </summary>
    static class StrokeFont
    {
        // Units of the table in one size of the font, the height of a line, and width of a unit over its height.
        const float UnitsOfSize = 8, LineUnits = 10, Narrowing = 0.85f;

        // Gap between characters and width of a space, units.
        const float Gap = 1.7f, Space = 3;

        // A character, then its lines: corners as x and y in units. The baseline is at y = 2, small letters reach 6,
        // capitals and digits 8.
        const string Table = @"! 08 04|02 03
"" 08 06|28 26
# 12 18|32 38|04 44|06 46
$ 47 38 18 07 06 15 35 44 43 32 12 03|29 21
% 02 48|08 18 17 07 08|33 43 42 32 33
& 42 06 07 18 28 37 36 04 03 12 22 44
' 08 06
( 29 17 13 21
) 09 17 13 01
* 23 27|04 46|06 44
+ 05 45|23 27
, 12 00
- 05 35
. 02 03
/ 01 49
0 12 32 43 47 38 18 07 03 12
1 17 28 22|12 32
2 07 18 38 47 46 02 42
3 07 18 38 47 46 35 44 43 32 12 03|15 35
4 32 38 04 44
5 48 08 05 35 44 43 32 12 03
6 47 38 18 07 03 12 32 43 44 35 15 04
7 08 48 12
8 15 35 46 47 38 18 07 06 15 04 03 12 32 43 44 35
9 03 12 32 43 47 38 18 07 06 15 35 46
: 02 03|05 06
; 12 00|15 16
< 47 05 43
= 04 44|06 46
> 07 45 03
? 07 18 38 47 46 25 24|22 23
@ 32 12 03 07 18 38 47 44 24 26 46
A 02 28 42|14 34
B 02 08 38 47 46 35 44 43 32 02|05 35
C 47 38 18 07 03 12 32 43
D 02 08 28 46 44 22 02
E 48 08 02 42|05 35
F 48 08 02|05 35
G 47 38 18 07 03 12 32 43 45 25
H 08 02|48 42|05 45
I 02 22|08 28|18 12
J 38 33 22 12 03
K 08 02|48 04|15 42
L 08 02 42
M 02 08 25 48 42
N 02 08 42 48
O 12 42 53 57 48 18 07 03 12
P 02 08 38 47 46 35 05
Q 12 42 53 57 48 18 07 03 12|34 51
R 02 08 38 47 46 35 05|25 42
S 47 38 18 07 06 15 35 44 43 32 12 03
T 08 48|28 22
U 08 03 12 32 43 48
V 08 22 48
W 08 12 37 52 68
X 08 42|02 48
Y 08 25 48|25 22
Z 08 48 02 42
[ 29 09 01 21
\ 09 41
] 09 29 21 01
^ 06 28 46
_ 01 51
` 08 16
a 16 36 45 42|43 32 12 03 14 44
b 08 02|05 16 36 45 43 32 12 03
c 45 36 16 05 03 12 32 43
d 48 42|45 36 16 05 03 12 32 43
e 04 44 45 36 16 05 03 12 32 43
f 38 28 17 12|06 26
g 46 41 30 10 01|45 36 16 05 03 12 32 43
h 08 02|05 16 36 45 42
i 06 02|08 08
j 16 11 00|18 18
k 08 02|36 03|14 32
l 08 03 12
m 06 02|05 16 26 35 32|35 46 56 65 62
n 06 02|05 16 36 45 42
o 12 32 43 45 36 16 05 03 12
p 06 00|05 16 36 45 43 32 12 03
q 46 40|45 36 16 05 03 12 32 43
r 06 02|05 16 36
s 45 36 16 05 14 34 43 32 12 03
t 18 13 22 32|06 36
u 06 03 12 32 43|46 42
v 06 22 46
w 06 12 35 52 66
x 06 42|02 46
y 06 22|46 10
z 06 46 02 42
{ 29 17 16 05 14 13 21
| 09 01
} 09 17 16 25 14 13 01
~ 04 15 25 34 44
° 16 07 18 27 16
± 06 46|24 28|03 43
× 03 47|07 43
Ä 02 28 42|14 34|09 09|49 49
Å 02 27 42|13 33|27 18 29 38 27
Ö 12 42 53 57 48 18 07 03 12|19 19|49 49
Ü 07 03 12 32 43 47|19 19|39 39
ß 02 07 18 28 37 36 25 15|25 44 43 32 12
ä 16 36 45 42|43 32 12 03 14 44|18 18|38 38
å 16 36 45 42|43 32 12 03 14 44|27 18 29 38 27
ö 12 32 43 45 36 16 05 03 12|18 18|38 38
ü 06 03 12 32 43|46 42|18 18|38 38
é 04 44 45 36 16 05 03 12 32 43|28 39";

        static readonly Dictionary<char, Vector2[][]> s_glyphs = Table.Split('\n')
            .ToDictionary(line => line[0], line => Glyph(line.Substring(2)));
        static readonly Vector2[][] s_box = Glyph("02 08 38 32 02");

        /// <summary>Width and height of a line of text.</summary>
        /// <param name="size">Size of the font, as CSS and UI Toolkit have it; the result is in the same unit.</param>
        public static Vector2 SizeOf(string text, float size) =>
            size / UnitsOfSize * new Vector2(Narrowing * (text.Sum(Advance) - Gap), LineUnits);

        /// <summary>The lines of a text, from its upper left corner; y downwards.</summary>
        public static IEnumerable<Vector2[]> Lines(string text, float size)
        {
            float scale = size / UnitsOfSize, x = 0;
            foreach (char character in text)
            {
                float left = x;
                foreach (var line in Of(character))
                    yield return line.Select(
                        corner => scale * new Vector2(Narrowing * (left + corner.x), LineUnits - corner.y)).ToArray();
                x += Advance(character);
            }
        }

        static float Advance(char character) =>
            Gap + (character == ' ' ? Space : Of(character).SelectMany(line => line).Max(corner => corner.x));

        static Vector2[][] Of(char character) => character == ' ' ? new Vector2[0][]
            : s_glyphs.TryGetValue(character, out var glyph) ? glyph : s_box;

        static Vector2[][] Glyph(string lines) => lines.Trim().Split('|').Select(line => line.Split(' ')
            .Select(corner => new Vector2(corner[0] - '0', corner[1] - '0')).ToArray()).ToArray();
    }
}
