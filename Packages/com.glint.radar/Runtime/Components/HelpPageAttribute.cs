using System;
using System.IO;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// The page of the package that the question mark in an inspector opens. It is a file: the package has no web site,
    /// and its pages are there offline.
    /// </summary>
    sealed class HelpPageAttribute : HelpURLAttribute
    {
        const string Folder = "Packages/com.glint.radar/Documentation~";

        // In the editor the current folder is the project's, and Unity resolves a package's path, wherever it lies.
        public HelpPageAttribute(string page) : base(new Uri(Path.GetFullPath($"{Folder}/{page}")).AbsoluteUri)
        {
        }
    }
}
