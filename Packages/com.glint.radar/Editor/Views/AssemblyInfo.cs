using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Glint.Host.Tests")]
