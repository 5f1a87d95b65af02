namespace Rabit.Mavlink.Generator.Reading;

/// <summary>One thing that is wrong with the definitions, and where.</summary>
/// <param name="Kind">What kind of thing.</param>
/// <param name="Path">File.</param>
/// <param name="Line">Line in the file, from 1; 0 where not known.</param>
/// <param name="Column">Column in the line, from 1; 0 where not known.</param>
/// <param name="Reason">What is wrong, in a sentence that names the thing.</param>
public sealed record DialectFault(DialectFaultKind Kind, string Path, int Line, int Column, string Reason)
{
    /// <summary>
    /// Whether the definitions can be used all the same: what is wrong may be meant so, or is ignored.
    /// </summary>
    public bool IsWarning
        => Kind is DialectFaultKind.UnknownName or DialectFaultKind.CommandOfPackage or DialectFaultKind.FieldTooNarrow
            or DialectFaultKind.EnumOfFloat or DialectFaultKind.UnnamedBits;
}
