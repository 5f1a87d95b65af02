using System;

namespace UavConsole;

/// <summary>How the lines and columns of a terminal are shared out. A plain value.</summary>
internal readonly struct ScreenLayout
{
    /// <summary>Below it there is no room for a map: plain lines.</summary>
    public const int MinMapWidth = 60;

    private const int MinMapHeight = 16;
    private const int MinHeightForManagers = 34;
    private const int ShortNotes = 3;
    private const int MaxMapRows = 48;

    /// <param name="width">Columns of the terminal.</param>
    /// <param name="height">Its lines.</param>
    /// <param name="managers">How many there are.</param>
    /// <param name="hasKeys">Whether the last line is for the keys.</param>
    public ScreenLayout(int width, int height, int managers, bool hasKeys)
    {
        HasMap = width >= MinMapWidth && height >= MinMapHeight;
        PanelWidth = !HasMap ? width : width >= 150 ? 64 : width >= 110 ? 46 : width >= 80 ? 38 : 34;
        MapColumns = Math.Max(1, width - PanelWidth - 2);
        ShowsManagerTable = HasMap && height >= MinHeightForManagers;
        int managerRows = ShowsManagerTable ? ((managers + 1) / 2) + 1 : HasMap ? 2 : 0;
        int left = Math.Max(0, height - 1 - managerRows - (hasKeys ? 1 : 0));
        int notes = height < MinHeightForManagers ? ShortNotes : ShortNotes + ((height - MinHeightForManagers) / 3);
        if (!HasMap)
            notes = Math.Min(ShortNotes, left / 4);
        PanelRows = Math.Min(HasMap ? MaxMapRows : int.MaxValue, left - notes);
        NoteRows = left - PanelRows;
    }

    public bool HasMap { get; }

    public int MapColumns { get; }

    public int PanelWidth { get; }

    /// <summary>Lines of the panel, and of the map beside it.</summary>
    public int PanelRows { get; }

    /// <summary>Whether each manager has its figures; otherwise there are two lines with their names.</summary>
    public bool ShowsManagerTable { get; }

    /// <summary>Last lines of the log.</summary>
    public int NoteRows { get; }
}
