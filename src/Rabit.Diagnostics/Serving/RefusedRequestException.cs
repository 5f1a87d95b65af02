using System;
using System.Diagnostics.CodeAnalysis;

namespace Rabit.Diagnostics.Serving;

/// <summary>A request that is answered with what is wrong with it.</summary>
[SuppressMessage("Design", "CA1032:Implement standard exception constructors",
    Justification = "It is internal, and has a text.")]
internal sealed class RefusedRequestException(string text, bool endsSession = false) : Exception(text)
{
    /// <summary>Whether what follows it cannot be understood either.</summary>
    public bool EndsSession { get; } = endsSession;
}
