using System;
using System.Diagnostics.CodeAnalysis;

namespace Rabit.Tool.Running;

/// <summary>A program cannot be looked into: one line for people, and the exit code.</summary>
[SuppressMessage("Design", "CA1032:Implement standard exception constructors",
    Justification = "It is internal, and has an exit code.")]
internal sealed class RunningException(string text, int exitCode) : Exception(text)
{
    public int ExitCode { get; } = exitCode;
}
