using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>
    /// The radar's view in a foldout. While open it is traced with each pose, or at the press of a button.
    /// </summary>
    sealed class RadarPreviewView : Foldout
    {
        const string ByBounces = "bounces", ByObject = "first object hit";

        readonly Image _image = new Image { scaleMode = ScaleMode.ScaleToFit };
        readonly DropdownField _colours = new DropdownField("Colour by", new List<string> { ByBounces, ByObject }, 0)
        {
            tooltip = "Colour by number of reflections, or by the first object hit. Brightness shows the angle of "
                + "incidence on it; white stripes are received rays."
        };
        readonly VisualElement _legend = new VisualElement();
        readonly Label _readout = new Label();
        Texture2D _texture;
        RadarPreview _preview;

        /// <param name="look">Traces the view of the scene in its current state.</param>
        public RadarPreviewView(Action look)
        {
            text = "Radar's view";
            value = false;
            var bar = new VisualElement();
            bar.AddToClassList("glint-buttons");
            bar.Add(_colours);
            bar.Add(new Button(look)
            {
                text = "Look now", tooltip = "Traces the view of the present scene. While this is unfolded, each "
                    + "traced pose is shown."
            });
            _legend.AddToClassList("glint-legend");
            _readout.AddToClassList("glint-words");
            Add(bar);
            Add(_image);
            Add(_legend);
            Add(_readout);
            _colours.RegisterValueChangedCallback(change => Draw());
            _image.RegisterCallback<PointerMoveEvent>(move => ReportPixel(move.localPosition));
            // A window's panel is detached and attached again when its tab changes.
            RegisterCallback<AttachToPanelEvent>(attach => Draw());
            RegisterCallback<DetachFromPanelEvent>(detach => UnityEngine.Object.DestroyImmediate(_texture));
        }

        /// <param name="preview">Null for none.</param>
        public void Show(RadarPreview preview)
        {
            if (preview == null || preview == _preview)
                return;
            _preview = preview;
            Draw();
        }

        /// <summary>The picture, a pixel a ray; null if nothing is shown.</summary>
        public byte[] Png() => _texture == null ? null : _texture.EncodeToPNG();

        void Draw()
        {
            if (_preview == null)
                return;
            bool byObject = _colours.value == ByObject;
            UnityEngine.Object.DestroyImmediate(_texture);
            _texture = new Texture2D(_preview.Width, _preview.Height, TextureFormat.RGBA32,
                false)
            { filterMode = FilterMode.Point, hideFlags = HideFlags.HideAndDontSave };
            _texture.SetPixels32(_preview.Colours(byObject));
            _texture.Apply();
            _image.image = _texture;
            _legend.Clear();
            foreach (var (colour, text) in _preview.Legend(byObject))
            {
                var entry = new VisualElement();
                entry.AddToClassList("glint-legend-entry");
                var key = new VisualElement { style = { backgroundColor = (Color)colour } };
                key.AddToClassList("glint-legend-key");
                entry.Add(key);
                entry.Add(new Label(text));
                _legend.Add(entry);
            }
        }

        // The picture is scaled to fit its element and centred.
        void ReportPixel(Vector2 pointer)
        {
            if (_preview == null)
                return;
            var size = _image.contentRect.size;
            float scale = Mathf.Min(size.x / _preview.Width, size.y / _preview.Height);
            int x = Mathf.FloorToInt((pointer.x - (size.x - scale * _preview.Width) / 2) / scale),
                y = _preview.Height - 1
                    - Mathf.FloorToInt((pointer.y - (size.y - scale * _preview.Height) / 2) / scale);
            _readout.text = x >= 0 && y >= 0 && x < _preview.Width && y < _preview.Height ? _preview.Text(x, y) : "";
        }
    }
}
