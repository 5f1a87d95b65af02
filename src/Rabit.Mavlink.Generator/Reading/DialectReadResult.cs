using System.Collections.Generic;
using Rabit.Mavlink.Generator.Model;

namespace Rabit.Mavlink.Generator.Reading;

/// <summary>What could be read, and everything that could not.</summary>
/// <param name="Dialect">
/// All valid definitions; a faulty message or entry is left out, so that one fault does not hide behind hundreds of
/// missing types.
/// </param>
/// <param name="Faults">
/// Everything wrong, in the order of reading; empty for valid definitions. Some are warnings.
/// </param>
public sealed record DialectReadResult(Dialect Dialect, IReadOnlyList<DialectFault> Faults);
