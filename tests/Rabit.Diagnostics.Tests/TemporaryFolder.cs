using System;
using System.IO;

namespace Rabit.Diagnostics.Tests;

/// <summary>A folder that goes with the test. Its path is short, as that of a socket must be.</summary>
internal sealed class TemporaryFolder : IDisposable
{
    public string Path { get; } = Directory.CreateTempSubdirectory("rd").FullName;

    /// <summary>Where the sockets go; it does not exist yet.</summary>
    public string Sockets => System.IO.Path.Combine(Path, "rabit");

    public void Dispose() => Directory.Delete(Path, recursive: true);
}
