namespace Rabit.Tool.Running;

/// <summary>A program that offers diagnostics, as its socket names it.</summary>
internal sealed record RunningProgram(string Path, string Name, int ProcessId)
{
    public override string ToString() => System.FormattableString.Invariant($"{Name} ({ProcessId})");
}
