using System;
using System.Collections.Generic;
using Rabit.Mavlink.Generator.Model;
using Rabit.Mavlink.Generator.Naming;

namespace Rabit.Mavlink.Generator.Emitting;

/// <summary>Where generated code goes.</summary>
/// <param name="Namespace">Namespace of the generated types.</param>
public sealed record EmitOptions(string Namespace)
{
    /// <summary>
    /// Name of the property of <c>MavlinkDialect</c> that gives the dialect. Only the package itself can add to that
    /// class; where this is null a class called after the root file, with <c>Dialect</c> appended, is made in
    /// <see cref="Namespace"/>.
    /// </summary>
    public string? DialectProperty { get; init; }

    /// <summary>
    /// Beside <see cref="DialectProperty"/>: names of properties that give a part of the dialect, by the name of its
    /// file (<c>common.xml</c>: <c>Common</c>).
    /// </summary>
    public IReadOnlyDictionary<string, string> PartProperties { get; init; } =
        new Dictionary<string, string>(StringComparer.Ordinal);

    /// <summary>What need not be generated because the package has it; null where the package itself is made.</summary>
    public ExistingTypes? Existing { get; init; }

    /// <summary>A dialect's name as a part of a namespace: <c>my-own.xml</c> is <c>MyOwn</c>.</summary>
    /// <param name="dialect">The dialect.</param>
    /// <returns>The name in Pascal case.</returns>
    public static string NameOf(Dialect dialect)
        => PascalCase.Of((dialect ?? throw new ArgumentNullException(nameof(dialect))).Name);
}
