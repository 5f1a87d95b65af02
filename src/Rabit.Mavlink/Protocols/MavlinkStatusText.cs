using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink;

/// <summary>A text for people, put together of all its chunks. A plain value.</summary>
/// <param name="Source">Who sent it.</param>
/// <param name="Severity">How severe, as the first of its chunks says that came.</param>
/// <param name="Text">The text; where chunks are missing, "…" stands for them.</param>
/// <param name="IsComplete">Whether nothing is missing.</param>
public readonly record struct MavlinkStatusText(
    MavlinkAddress Source, MavSeverity Severity, string Text, bool IsComplete);
