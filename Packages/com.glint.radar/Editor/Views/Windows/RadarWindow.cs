using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using Glint.Core;
using UnityEditor;
using UnityEditorInternal;
using UnityEngine;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>
    /// Window > Glint > Radar: traces and sweeps the open scene, in edit mode and in play mode,
    /// and shows the results live.
    /// </summary>
    sealed class RadarWindow : EditorWindow
    {
        const string StylePath = "Packages/com.glint.radar/Editor/Views/Windows/RadarWindow.uss";

        // Drawing charts of many poses takes longer than tracing a pose.
        const double SecondsBetweenDrawings = 0.2;

        [SerializeField] SweepForm _form = new SweepForm();
        [SerializeField] ChartChoice _choice = new ChartChoice();
        // Folder of the results shown, kept across a reload of the scripts; empty for none.
        [SerializeField] string _shown = "";
        // Folder or name of the published table of the compared run; empty for none.
        [SerializeField] string _compared = "";

        IReadOnlyList<StoredRow> _rows = Array.Empty<StoredRow>();
        Comparison _comparison;
        SweepSession _session;
        SweepPanel _panel;
        ResultsPanel _results;
        double _drawn;

        /// <summary>Opens the window for a radar.</summary>
        /// <param name="radar">Null: the one of the scene.</param>
        public static void Show(RadarController radar)
        {
            var window = GetWindow<RadarWindow>();
            if (radar != null)
                window._form.Radar = radar;
            window.Show();
            window.Refresh();
        }

        [MenuItem("Window/Glint/Radar")]
        static void Open() => Show(null);

        /// <summary>Gives an element, and those below it, the styles of charts.</summary>
        public static void AddStyle(VisualElement root)
        {
            var style = AssetDatabase.LoadAssetAtPath<StyleSheet>(StylePath);
            if (style != null)
                root.styleSheets.Add(style);
            root.AddToClassList(EditorGUIUtility.isProSkin ? "glint-dark" : "glint-light");
        }

        void OnEnable()
        {
            titleContent = new GUIContent("Radar");
            minSize = new Vector2(480, 300); // fits between the inspector and the scene on a laptop
            EditorApplication.update += Tick;
        }

        void OnDisable()
        {
            EditorApplication.update -= Tick;
            _session?.Dispose();
        }

        void OnFocus() => Refresh();

        void CreateGUI()
        {
            AddStyle(rootVisualElement);
            _panel = new SweepPanel(_form, () => Begin(() => SweepSession.Pose(_form.Radar)),
                () => Begin(() => SweepSession.Sweep(_form)), () => _session?.Cancel());
            _results = new ResultsPanel(_choice, Draw, Compare, SaveFile, SaveReport, SavePicture, Look, SavePreview);
            var split = new TwoPaneSplitView(0, 300, TwoPaneSplitViewOrientation.Horizontal);
            split.Add(_panel);
            split.Add(_results);
            rootVisualElement.Add(split);
            Refresh();
            Recall();
        }

        // Restores what was shown before a reload of the scripts.
        void Recall()
        {
            if (_session == null && _shown.Length > 0 && Directory.Exists(_shown))
                Attempt(() => _rows = StoredRun.RowsOf(_shown));
            Compare(_compared);
        }

        void Refresh()
        {
            if (_panel == null)
                return;
            _form.FindRadar();
            _panel.Reload();
            _panel.Show(_session);
            Draw();
        }

        void Draw()
        {
            _drawn = EditorApplication.timeSinceStartup;
            _results.Show(_rows, _comparison);
        }

        void Begin(Func<SweepSession> begin) => Attempt(() =>
        {
            _panel.Report(null);
            _session?.Dispose();
            _session = begin();
            _rows = _session.Rows;
            _shown = _session.FolderPath ?? "";
            _choice.Pose = -1;
            Refresh();
        });

        void Tick()
        {
            if (_session == null || !_session.IsRunning || _panel == null)
                return;
            _session.Looks = _results.Preview.value;
            using (var progress = new PoseProgress(_session))
                _session.Tick(progress);
            _panel.Show(_session);
            _results.Preview.Show(_session.Preview);
            InternalEditorUtility.RepaintAllViews(); // for the target's rotation and the ray paths
            if (!_session.IsRunning)
                Refresh();
            else if (EditorApplication.timeSinceStartup - _drawn > SecondsBetweenDrawings)
                Draw();
        }

        void Compare(string with) => Attempt(() =>
        {
            _compared = "";
            _comparison = null;
            try
            {
                foreach (var table in PublishedTable.All)
                    if (table.Name == with)
                        _comparison = Comparison.With(table);
                if (_comparison == null && with.Length > 0)
                    _comparison = Comparison.With(with);
                _compared = with;
            }
            finally
            {
                Draw();
            }
        });

        void Look() => Attempt(() =>
        {
            if (_form.Radar == null)
                throw new GlintException("choose a radar first");
            try
            {
                using (var bar = new CancelBar($"The view of '{_form.Radar.name}'"))
                    _results.Preview.Show(RadarPreview.Of(_form.Radar, bar.Cancel));
            }
            finally
            {
                // A sweep, and the scene in play mode, keep its buffers.
                if (_session?.IsRunning != true && !Application.isPlaying)
                    _form.Radar.Release();
            }
        });

        void SavePreview()
        {
            var png = _results.Preview.Png();
            if (png == null)
            {
                _panel.Report("there is no radar's view yet: unfold it and press Look now");
                return;
            }
            Save("", "view.png", path => Export.Picture(png, path));
        }

        void SaveFile(string name) => Attempt(() =>
        {
            string shown = RequireShown();
            Save("", name, path => Export.Copy(shown, name, path));
        });

        void SaveReport() => Attempt(() =>
        {
            if (_session?.IsRunning == true)
                throw new GlintException("the sweep is running: export its report when it is done, or cancel it");
            string shown = RequireShown();
            Save(shown, ReportFile.Name, path =>
            {
                using (var progress = new CancelBar("Report"))
                    Export.Report(shown, _choice.Row(_rows), _form, path, progress);
            });
        });

        // A pose that is traced alone has no folder.
        string RequireShown() => _shown.Length > 0 ? _shown
            : throw new GlintException("no sweep is shown whose files could be exported: sweep first");

        // To where the user says, if anywhere.
        void Save(string folder, string name, Action<string> write) => Attempt(() =>
        {
            string path =
                EditorUtility.SaveFilePanel("Export", folder, name, Path.GetExtension(name).TrimStart('.'));
            if (path.Length > 0)
                write(path);
        });

        void SavePicture() => Save("", "chart.png", path => Export.Picture(
            ChartPicture.Draw(_choice.Chart(_rows, _comparison), _choice.Chosen(_rows)).Png(), path));

        // Shows errors in the window.
        void Attempt(Action act)
        {
            try
            {
                act();
            }
            catch (GlintException problem)
            {
                _panel.Report(problem.Message);
            }
            catch (OperationCanceledException)
            {
            }
        }
    }

    /// <summary>
    /// Progress of a long pose, with a cancel button. A pose blocks the editor, so that the window's own Cancel cannot
    /// be pressed.
    /// </summary>
    sealed class PoseProgress : IProgress<double>, IDisposable
    {
        const double SecondsUntilShown = 1;

        readonly Stopwatch _watch = Stopwatch.StartNew();
        readonly SweepSession _session;
        bool _isShown;

        public PoseProgress(SweepSession session) => _session = session;

        public void Report(double value)
        {
            if (_watch.Elapsed.TotalSeconds < SecondsUntilShown)
                return;
            _isShown = true;
            if (EditorUtility.DisplayCancelableProgressBar("Glint",
                $"{_session.Status()}; the next {100 * value:0} % done", (float)value))
                _session.Cancel();
        }

        public void Dispose()
        {
            if (_isShown)
                EditorUtility.ClearProgressBar();
        }
    }
}
