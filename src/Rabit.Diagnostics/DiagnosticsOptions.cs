using System;

namespace Rabit.Diagnostics;

/// <summary>Where a program offers its diagnostics. Read once, when they are opened.</summary>
public sealed class DiagnosticsOptions
{
    /// <summary>
    /// The name under which tools find the program. Whatever is not A to Z, a digit, dot, hyphen or underscore becomes
    /// an underscore, and what is longer than 40 characters is cut.
    /// </summary>
    /// <value>Null, the default: that of the program's assembly.</value>
    public string? Program { get; set; }

    /// <summary>
    /// The folder of the socket, which must belong to the user of the process. It is made, and closed to all others.
    /// </summary>
    /// <value>
    /// Null, the default: <c>$XDG_RUNTIME_DIR/rabit</c>, or, where that variable is not set, <c>/tmp/rabit-UID</c>.
    /// </value>
    public string? Folder { get; set; }

    /// <summary>The clock that paces the answers.</summary>
    internal TimeProvider Clock { get; set; } = TimeProvider.System;

    /// <summary>How long clients may take.</summary>
    internal Serving.ClientLimits Limits { get; set; } = new();
}
