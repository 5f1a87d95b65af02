using System.Collections.Generic;
using System.Linq;

namespace UavConsole;

/// <summary>A map in characters. Immutable.</summary>
internal sealed class MapPicture(char[][] characters, MapInk[][] inks)
{
    /// <summary>From the top; all of the same length.</summary>
    public IReadOnlyList<string> Lines { get; } = [.. characters.Select(row => new string(row))];

    /// <summary>What each character shows.</summary>
    public MapInk InkAt(int column, int row) => inks[row][column];
}
