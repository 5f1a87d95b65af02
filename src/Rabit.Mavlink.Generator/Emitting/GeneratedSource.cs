namespace Rabit.Mavlink.Generator.Emitting;

/// <summary>One generated file.</summary>
/// <param name="Name">File name, unique in the dialect also where case does not count.</param>
/// <param name="Text">C# 7.3.</param>
public sealed record GeneratedSource(string Name, string Text);
