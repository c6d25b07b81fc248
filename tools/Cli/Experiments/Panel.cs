namespace Glint.Cli;

/// <summary>One panel of a <see cref="Chart"/>.</summary>
sealed record Panel(string Title, ValueScale Scale, params ChartLine[] Lines);
