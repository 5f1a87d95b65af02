namespace UavConsole;

/// <summary>What was asked for, and by what: an option, or file and key. Immutable.</summary>
/// <param name="Value">What was asked for.</param>
/// <param name="Name">For errors.</param>
internal readonly record struct Setting<T>(T Value, string Name);
