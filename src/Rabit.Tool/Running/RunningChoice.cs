namespace Rabit.Tool.Running;

/// <summary>Which program the user means, by folder and name; null where not said.</summary>
internal sealed record RunningChoice(string? Folder, string? Name)
{
    /// <exception cref="RunningException">There is none, there are several, or it cannot be reached.</exception>
    public DiagnosticsClient Connect() => Connect(RunningPrograms.Choose(Folder, Name));

    /// <exception cref="RunningException">It cannot be reached.</exception>
    public DiagnosticsClient Connect(RunningProgram program)
        => DiagnosticsClient.Connect(program, mayBeOfOthers: Folder is not null);
}
