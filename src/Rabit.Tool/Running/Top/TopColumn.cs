namespace Rabit.Tool.Running.Top;

/// <summary>A column of a table.</summary>
/// <param name="Head">Its first line.</param>
/// <param name="Rank">
/// Where the terminal is too narrow, columns with the highest rank are left out first; 0 never.
/// </param>
/// <param name="IsNumber">Whether it is set to the right.</param>
/// <param name="MinWidth">So that columns do not move with each figure.</param>
internal sealed record TopColumn(string Head, int Rank, bool IsNumber = true, int MinWidth = 6);
