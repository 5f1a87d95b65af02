using System;
using Rabit.Mavlink.Generator.Model;
using Rabit.Mavlink.Generator.Naming;

namespace Rabit.Mavlink.Generator.Emitting;

/// <summary>Where generated code goes.</summary>
/// <param name="Namespace">Namespace of the generated types.</param>
public sealed record EmitOptions(string Namespace)
{
    /// <summary>
    /// Name of the property of <c>MavlinkDialect</c> that gives the dialect. Only the package itself can add to that class; where
    /// this is null a class called after the root file, with <c>Dialect</c> behind it, is made in <see cref="Namespace"/>.
    /// </summary>
    public string? DialectProperty { get; init; }

    /// <summary>The namespace of a dialect whose user chose none.</summary>
    /// <param name="dialect">The dialect.</param>
    /// <returns>One of its own below that of the package's messages.</returns>
    public static string DefaultNamespace(Dialect dialect) =>
        "Rabit.Mavlink.Messages." + PascalCase.Of((dialect ?? throw new ArgumentNullException(nameof(dialect))).Name) + "Dialect";
}
