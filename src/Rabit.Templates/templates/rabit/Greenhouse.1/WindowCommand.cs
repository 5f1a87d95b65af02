namespace Greenhouse._1;

/// <summary>What the window shall do. It goes through a queue: every command arrives, in order.</summary>
/// <param name="Opens">False closes it.</param>
public readonly record struct WindowCommand(bool Opens);
