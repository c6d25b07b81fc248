using System;
using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEditor.UIElements;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>Building blocks of the inspectors.</summary>
    static class Parts
    {
        /// <summary>A foldout that keeps its state.</summary>
        public static Foldout Group(string title, params VisualElement[] parts)
        {
            var group = new Foldout { text = title, viewDataKey = "Glint." + title };
            foreach (var part in parts)
                group.Add(part);
            return group;
        }

        /// <summary>A serialized field of the object inspected; its tooltip is the field's.</summary>
        public static PropertyField Field(string name, string label) =>
            new PropertyField { bindingPath = name, label = label };

        /// <summary>A serialized struct of plain C#, whose fields have no tooltips of their own.</summary>
        public static Foldout Struct(string name, string title,
            IEnumerable<(string field, string label, string tooltip)> fields) =>
            Group(title, fields.Select(it => new PropertyField
            {
                bindingPath = name + "." + it.field, label = it.label, tooltip = it.tooltip
            }).ToArray());

        /// <summary>
        /// Shows figures in the columns of the fields, as selectable text. Fields that are there stay, with what a user
        /// has selected in them.
        /// </summary>
        public static void ShowRows(VisualElement parent,
            IEnumerable<(string label, string value, string tooltip)> rows)
        {
            var figures = rows.ToArray();
            var fields = parent.Children().OfType<TextField>().ToList();
            if (!fields.Select(field => field.label).SequenceEqual(figures.Select(figure => figure.label)))
            {
                parent.Clear();
                fields.Clear();
                foreach (var (label, _, _) in figures)
                {
                    var field = new TextField(label) { isReadOnly = true };
                    field.AddToClassList(TextField.alignedFieldUssClassName);
                    parent.Add(field);
                    fields.Add(field);
                }
            }
            for (int i = 0; i < figures.Length; i++)
                (fields[i].value, fields[i].tooltip) = (figures[i].value, figures[i].tooltip);
        }

        /// <summary>Shows findings, each with the button of its fix.</summary>
        /// <param name="mended">Called after a fix.</param>
        public static void ShowFindings(VisualElement parent, IEnumerable<Finding> findings, Action mended)
        {
            parent.Clear();
            foreach (var finding in findings)
            {
                var box = new HelpBox(finding.Text,
                    finding.Severity == Severity.Error ? HelpBoxMessageType.Error : HelpBoxMessageType.Warning);
                if (finding.Where != null)
                    box.Add(new Button(() => EditorGUIUtility.PingObject(finding.Where))
                    {
                        text = "Show", tooltip = $"Shows '{finding.Where.name}' in the Hierarchy."
                    });
                if (finding.Fix != null)
                    box.Add(new Button(() => { finding.Fix.Apply(); mended(); }) { text = finding.Fix.Label });
                parent.Add(box);
            }
        }
    }
}
