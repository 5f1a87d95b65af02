using System;
using System.IO;
using Rabit.Uav.Simulation;

namespace Rabit.Tool.Simulation;

/// <summary>
/// The file of the truth (docs/concepts/simulation.md): where the targets are, at the start, so that a mission can be
/// scored; at the end again, with what the vehicle did.
/// </summary>
internal sealed class TruthOutput : IDisposable
{
    private readonly FileStream _file;

    private TruthOutput(FileStream file) => _file = file;

    // What was there before stays until there is something to put in its place.
    public static TruthOutput? Open(string? path)
        => path is null
            ? null
            : new TruthOutput(new FileStream(path, FileMode.OpenOrCreate, FileAccess.Write, FileShare.Read));

    /// <summary>Writes all that is known, in place of what was written before.</summary>
    public void Write(SimulatedWorld world)
    {
        _file.SetLength(0);
        TruthFile.Write(_file, world);
        _file.Flush();
    }

    public void Dispose() => _file.Dispose();
}
