using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Glint.Editor")]
[assembly: InternalsVisibleTo("Glint.Tests.EditMode")]
[assembly: InternalsVisibleTo("Glint.Tests.PlayMode")]
[assembly: InternalsVisibleTo("Glint.Host")]
[assembly: InternalsVisibleTo("Glint.Host.Tests")]
[assembly: InternalsVisibleTo("glint-cli")]
