namespace Rabit.Mavlink.Generator.Model;

/// <summary>Where something is defined.</summary>
/// <param name="Path">File.</param>
/// <param name="Line">Line in the file, from 1; 0 where not known.</param>
/// <param name="Column">Column in the line, from 1; 0 where not known.</param>
public sealed record DefinitionPlace(string Path, int Line, int Column)
{
    /// <summary>Name of the file without folder.</summary>
    public string FileName => System.IO.Path.GetFileName(Path.Replace('\\', '/'));
}
