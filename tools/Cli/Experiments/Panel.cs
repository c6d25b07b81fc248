namespace Glint.Cli;

/// <summary>One of the pictures side by side in a <see cref="Chart"/>.</summary>
sealed record Panel(string Title, ValueScale Scale, params ChartLine[] Lines);
