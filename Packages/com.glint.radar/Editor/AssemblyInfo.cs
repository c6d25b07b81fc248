using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Glint.Editor.Views")]
[assembly: InternalsVisibleTo("Glint.Tests.EditMode")]
[assembly: InternalsVisibleTo("Glint.Host.Tests")]
[assembly: InternalsVisibleTo("glint-cli")]
