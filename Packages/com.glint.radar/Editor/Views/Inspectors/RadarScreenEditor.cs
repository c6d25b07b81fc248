using System.Collections.Generic;
using UnityEditor;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>The inspector of a RadarScreen: settings with units and ranges, and what follows from them.</summary>
    [CustomEditor(typeof(RadarScreen)), CanEditMultipleObjects]
    sealed class RadarScreenEditor : FiguresEditor
    {
        RadarScreen Screen => (RadarScreen)target;

        protected override void AddFields(VisualElement inspector)
        {
            inspector.Add(Parts.Group("Scene", Parts.Field("_ownShip", "Own Ship"), Parts.Field("_sea", "Sea"),
                Parts.Field("_layers", "Layers")));
            inspector.Add(Parts.Struct("_radar", "Radar", ScreenFigures.Radar));
            inspector.Add(Parts.Field("_patternTable", "Pattern Table"));
            inspector.Add(Parts.Struct("_receiver", "Receiver", ScreenFigures.Receiver));
            inspector.Add(Parts.Struct("_display", "Display", ScreenFigures.Display));
            inspector.Add(Parts.Struct("_detection", "Detection", ScreenFigures.Detection));
            inspector.Add(Parts.Group("Colours", Parts.Field("_outside", "Outside"),
                Parts.Field("_background", "Background"), Parts.Field("_echo", "Echo"), Parts.Field("_trail", "Trails"),
                Parts.Field("_rings", "Range Rings"), Parts.Field("_heading", "Heading Line"),
                Parts.Field("_marker", "Bearing Line and Marker")));
            inspector.Add(Parts.Group("Kernels", Parts.Field("_kernel", "Kernel"),
                Parts.Field("_seaKernel", "Sea Kernel")));
        }

        protected override (IEnumerable<Finding>, IEnumerable<(string, string, string)>) Shown() =>
            (new[] { ScreenFigures.Check(Screen) }, ScreenFigures.Rows(Screen));
    }
}
