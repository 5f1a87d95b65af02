using System;
using System.Diagnostics.CodeAnalysis;

namespace Rabit.Diagnostics.Serving;

/// <summary>A client that does not take what it asked for.</summary>
[SuppressMessage("Design", "CA1032:Implement standard exception constructors",
    Justification = "It is internal, and says it all.")]
internal sealed class SlowClientException : Exception;
