using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using UnityEditor.UIElements;
using UnityEngine;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>The window's left side: the form of the sweep, and the buttons.</summary>
    sealed class SweepPanel : ScrollView
    {
        readonly SweepForm _form;
        readonly Dictionary<SweepAxis, Label> _axisProblems = new Dictionary<SweepAxis, Label>();
        readonly ObjectField _radar, _target;
        readonly Toggle _resume;
        readonly Button _trace, _sweep, _cancel;
        readonly ProgressBar _progress = new ProgressBar { lowValue = 0 };
        readonly Label _folder = MakeLabel("glint-status"), _problem = MakeLabel("glint-problem"),
            _status = MakeLabel("glint-problem");
        bool _isRunning;

        /// <param name="form">Edited by the panel.</param>
        public SweepPanel(SweepForm form, Action trace, Action sweep, Action cancel)
        {
            AddToClassList("glint-controls");
            _form = form;
            _radar = AddObject<RadarController>("Radar", form.Radar, "The radar that traces.",
                chosen => form.Radar = chosen);
            _target = AddObject<Transform>("Target", form.Target, Options.Target.Help, chosen => form.Target = chosen);
            foreach (var axis in SweepAxis.All.Reverse())
            {
                AddText(axis.ListLabel, form[axis], axis.Help, text => form[axis] = text);
                Add(_axisProblems[axis] = MakeLabel("glint-problem"));
            }
            AddText("Results folder", form.Folder, "For results.csv and results.json, relative to the project. Empty: "
                + "Results/<scene> beside Assets.", text => form.Folder = text);
            Add(_folder);
            _resume = new Toggle("Resume") { value = form.Resume, tooltip = Options.Resume.Help };
            _resume.RegisterValueChangedCallback(change => form.Resume = change.newValue);
            Add(_resume);
            var buttons = new VisualElement();
            buttons.AddToClassList("glint-buttons");
            buttons.Add(
                _trace = new Button(trace) { text = "Trace", tooltip = "Traces one pose, without files." });
            buttons.Add(_sweep = new Button(sweep) { text = "Sweep" });
            buttons.Add(_cancel = new Button(cancel)
            {
                text = "Cancel", tooltip = "Finished poses are kept; Resume continues."
            });
            Add(buttons);
            Add(_problem);
            Add(_progress);
            Add(_status);
        }

        /// <summary>Updates the fields to the form.</summary>
        public void Reload()
        {
            _radar.SetValueWithoutNotify(_form.Radar);
            _target.SetValueWithoutNotify(_form.Target);
            Check();
        }

        /// <summary>Shows an error.</summary>
        /// <param name="mishap">Null for none.</param>
        public void Report(string mishap) => SetText(_status, mishap);

        // Shows the errors of the form and enables the buttons.
        void Check()
        {
            foreach (var entry in _axisProblems)
                SetText(entry.Value, _form.ProblemOf(entry.Key));
            string problem = _form.Problem();
            SetText(_problem, problem);
            _folder.text = _form.FolderText(_isRunning);
            _trace.SetEnabled(!_isRunning && _form.Radar != null);
            _sweep.SetEnabled(!_isRunning && problem == null);
            _cancel.SetEnabled(_isRunning);
        }

        /// <summary>Shows the state of a session.</summary>
        /// <param name="session">Null for none.</param>
        public void Show(SweepSession session)
        {
            bool wasRunning = _isRunning;
            _isRunning = session?.IsRunning == true;
            _progress.highValue = session == null ? 1 : session.Count;
            _progress.value = session?.Done ?? 0;
            _progress.title = session?.Status() ?? "";
            if (wasRunning && !_isRunning)
                Report(session?.Problem);
            if (_isRunning != wasRunning)
                Check();
        }

        ObjectField AddObject<T>(string label, T value, string help, Action<T> set) where T : Component
        {
            var field = new ObjectField(label)
            {
                objectType = typeof(T), allowSceneObjects = true, value = value, tooltip = help
            };
            field.RegisterValueChangedCallback(change =>
            {
                set(change.newValue as T);
                Check();
            });
            Add(field);
            return field;
        }

        void AddText(string label, string value, string help, Action<string> set)
        {
            var field = new TextField(label) { value = value, tooltip = help };
            field.RegisterValueChangedCallback(change =>
            {
                set(change.newValue);
                Check();
            });
            Add(field);
        }

        static Label MakeLabel(string kind)
        {
            var label = new Label();
            label.AddToClassList(kind);
            return label;
        }

        static void SetText(Label label, string text)
        {
            label.text = text ?? "";
            label.style.display = string.IsNullOrEmpty(text) ? DisplayStyle.None : DisplayStyle.Flex;
        }
    }
}
