namespace Rabit.Mavlink.Generator.Reading;

/// <summary>One definition file. The reader never opens files itself: a compiler hands over what it has.</summary>
/// <param name="Path">Where it came from; includes are resolved relative to it, faults name it.</param>
/// <param name="Text">The XML.</param>
public sealed record DialectFile(string Path, string Text);
