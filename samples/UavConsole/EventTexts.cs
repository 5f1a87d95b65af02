using System;
using System.IO;
using Rabit.Mavlink;
using Rabit.Uav.AutopilotInterface;

namespace UavConsole;

/// <summary>Where the texts of PX4's events come from.</summary>
internal static class EventTexts
{
    private const string Fetch = "fetch";

    /// <exception cref="ArgumentException">The file is none; the text says why.</exception>
    public static void ApplyTo(AutopilotOptions options, string? file)
    {
        if (file == Fetch)
            options.FetchesEventCatalog = true;
        else if (file is not null)
            options.EventCatalog = Read(file);
    }

    private static MavlinkEventCatalog Read(string file)
    {
        try
        {
            using FileStream stream = File.OpenRead(file);
            return MavlinkEventCatalog.Read(stream);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException)
        {
            throw new ArgumentException($"--px4-events {file} cannot be read: {e.Message}", nameof(file), e);
        }
        catch (FormatException e)
        {
            throw new ArgumentException($"--px4-events {file}: {e.Message}.", nameof(file), e);
        }
    }
}
