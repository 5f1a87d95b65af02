using System.Collections.Generic;

namespace Rabit.Mavlink.Generator.Model;

/// <summary>One file of a dialect, which with what it includes is a dialect as well.</summary>
/// <param name="File">File name without folder.</param>
/// <param name="Files">Itself and the files that it includes, directly or through others; names without folder.</param>
public sealed record DialectPart(string File, IReadOnlyCollection<string> Files);
