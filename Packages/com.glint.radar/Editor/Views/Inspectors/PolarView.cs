using System;
using System.Collections.Generic;
using Glint.Core;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>Draws a <see cref="PolarPlot"/>.</summary>
    sealed class PolarView : VisualElement
    {
        PolarPlot _plot;

        public PolarView()
        {
            AddToClassList("glint-polar");
            generateVisualContent =
                context => Drawing?.Draw(new PainterCanvas(context.painter2D), ChartColours.Skin);
            RegisterCallback<GeometryChangedEvent>(changed => Write());
        }

        // Null while there is nothing to draw, or no room.
        PolarDrawing Drawing => _plot != null && contentRect.width > 1 && contentRect.height > 1
            ? new PolarDrawing(_plot, contentRect) : null;

        /// <summary>Shows rows, or nothing if there are none.</summary>
        /// <param name="plan">Of the rows.</param>
        public void Show(IReadOnlyList<CrossSectionRow> rows, CrossSectionPlan plan)
        {
            _plot = rows.Count > 0 ? new PolarPlot(rows, plan.IsReceiverSweep) : null;
            style.display = _plot != null ? DisplayStyle.Flex : DisplayStyle.None;
            Write();
            MarkDirtyRepaint();
        }

        void Write() => ChartLabels.Write(this, Drawing?.Texts() ?? Array.Empty<ChartText>());
    }
}
