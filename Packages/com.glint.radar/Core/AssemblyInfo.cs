using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Glint.Tests.EditMode")]
[assembly: InternalsVisibleTo("Glint.Tests.PlayMode")]
[assembly: InternalsVisibleTo("Glint.Host.Tests")]
