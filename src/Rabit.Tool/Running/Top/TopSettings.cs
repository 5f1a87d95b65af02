namespace Rabit.Tool.Running.Top;

/// <summary>What a person wants to see, changed by keys.</summary>
internal sealed class TopSettings
{
    public TopSection Section { get; set; }

    public TopOrder Order { get; set; }

    public bool IsReversed { get; set; }

    /// <summary>A part of the names that are shown; empty for all.</summary>
    public string Filter { get; set; } = string.Empty;

    /// <summary>Whether the filter is being typed.</summary>
    public bool IsTyping { get; set; }

    /// <summary>How many rows are above the picture.</summary>
    public int Scroll { get; set; }

    public bool Shows(TopTable table) => Section == TopSection.All || Section == table.Section;
}
