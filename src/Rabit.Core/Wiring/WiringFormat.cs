namespace Rabit.Core;

/// <summary>How a wiring is written.</summary>
public enum WiringFormat
{
    /// <summary>For people.</summary>
    Text,

    /// <summary>A Mermaid flowchart, which many viewers of Markdown draw.</summary>
    Mermaid,

    /// <summary>The DOT language of Graphviz.</summary>
    Dot,
}
