using System;
using System.Collections.Generic;
using Rabit.Mavlink;

namespace Rabit.Uav.Simulation;

/// <summary>The files that ArduPilot serves here: its parameters, packed.</summary>
internal sealed class ArdupilotFiles(ParameterStore parameters) : IMavlinkFileStore
{
    private const string Folder = "@PARAM";

    public bool TryGetFile(string path, out ReadOnlyMemory<byte> content)
    {
        byte[]? file = PackedParameters.Find(parameters, path);
        content = file;
        return file is not null;
    }

    public bool TryGetDirectory(string path, out IReadOnlyList<MavlinkFileEntry> entries)
    {
        entries = path switch
        {
            "" => [new MavlinkFileEntry(Folder, 0, IsDirectory: true)],
            Folder => [new MavlinkFileEntry(
                "param.pck", PackedParameters.Find(parameters, PackedParameters.Path)!.Length, IsDirectory: false)],
            _ => [],
        };
        return entries.Count > 0;
    }
}
