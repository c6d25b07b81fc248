using System.Linq;
using UnityEngine;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>Colours of a chart, from RadarWindow.uss.</summary>
    sealed class ChartColours
    {
        static readonly CustomStyleProperty<Color> s_grid = new CustomStyleProperty<Color>("--glint-grid");
        static readonly CustomStyleProperty<Color> s_frame = new CustomStyleProperty<Color>("--glint-frame");
        static readonly CustomStyleProperty<Color> s_mark = new CustomStyleProperty<Color>("--glint-mark");
        static readonly CustomStyleProperty<Color> s_uncertainty = new CustomStyleProperty<Color>("--glint-doubt");
        static readonly CustomStyleProperty<Color>[] s_lines = Enumerable.Range(0, 6)
            .Select(i => new CustomStyleProperty<Color>($"--glint-line-{i}")).ToArray();

        readonly Color[] _lines = s_lines.Select(line => Color.gray).ToArray();
        Color _grid = Color.gray, _frame = Color.gray, _mark = Color.gray, _uncertainty = Color.gray;

        /// <summary>Follows an element's style and repaints it on changes.</summary>
        public ChartColours(VisualElement element) => element.RegisterCallback<CustomStyleResolvedEvent>(resolved =>
        {
            Read(resolved.customStyle, s_grid, ref _grid);
            Read(resolved.customStyle, s_frame, ref _frame);
            Read(resolved.customStyle, s_mark, ref _mark);
            Read(resolved.customStyle, s_uncertainty, ref _uncertainty);
            for (int i = 0; i < _lines.Length; i++)
                Read(resolved.customStyle, s_lines[i], ref _lines[i]);
            element.MarkDirtyRepaint();
        });

        public Color Grid => _grid;

        public Color Frame => _frame;

        /// <summary>Colour of the chosen pose.</summary>
        public Color Mark => _mark;

        /// <summary>Colour of undersampled poses.</summary>
        public Color Uncertainty => _uncertainty;

        /// <summary>Colour of a line, from 0.</summary>
        public Color Line(int series) => _lines[series % _lines.Length];

        static void Read(ICustomStyle style, CustomStyleProperty<Color> property, ref Color colour)
        {
            if (style.TryGetValue(property, out var found))
                colour = found;
        }
    }
}
