using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Rabit.Uav.Communications;

/// <summary>
/// Where the frames of the live links are recorded, as telemetry logs (.tlog) that every ground station reads.
/// </summary>
/// <example>
/// <code>
/// options.Communications.Recording = new RecordingOptions { Folder = "/home/pi/flights", Name = "survey" };
/// </code>
/// </example>
public sealed class RecordingOptions
{
    /// <summary>The least size of a file: some seconds of the busiest autopilot.</summary>
    public const long MinFileBytes = 100_000;

    private const int MaxNameLength = 60;

    // The same everywhere, so that a card can be read on another computer.
    private const string NotInNames = "/\\:*?\"<>|\0\n\r\t";

    /// <summary>The folder, which is made where it is not there.</summary>
    /// <value>The default is ".", the current folder.</value>
    public string Folder { get; set; } = ".";

    /// <summary>
    /// Whether a folder that cannot be written is refused at the start. Where it is not, the run begins without a
    /// recording, and what is not recorded is counted and reported; files are begun as soon as the folder can be
    /// written.
    /// </summary>
    /// <value>The default is true.</value>
    public bool IsRequired { get; set; } = true;

    /// <summary>
    /// How the files are called: Name-DATE-TIME.tlog, by the time of the first frame (UTC), then -2, -3 and so on.
    /// </summary>
    /// <value>The default is "rabit".</value>
    public string Name { get; set; } = "rabit";

    /// <summary>How large a file may become before the next one is begun, bytes.</summary>
    /// <value>The default is 256 MB: three hours of PX4's usual stream.</value>
    public long MaxFileBytes { get; set; } = 256_000_000;

    /// <summary>
    /// How many files one run may keep; the oldest of the run is deleted for a new one. Files of other runs stay.
    /// </summary>
    /// <value>The default is 16.</value>
    public int MaxFiles { get; set; } = 16;

    /// <summary>How many frames may wait for the disk; those for which there is no room are counted.</summary>
    /// <value>The default is 4096: ten seconds of PX4's usual stream.</value>
    public int FramesWaiting { get; set; } = 4096;

    /// <summary>How a file is made; for tests.</summary>
    internal Func<string, Stream> CreatesFile { get; set; }
        = path => new FileStream(path, FileMode.CreateNew, FileAccess.Write, FileShare.Read, bufferSize: 1);

    internal RecordingOptions Copy() => (RecordingOptions)MemberwiseClone();

    internal IEnumerable<string> FindFaults()
    {
        if (string.IsNullOrWhiteSpace(Folder))
            yield return $"{nameof(Folder)} is empty; \".\" is the current one";
        if (string.IsNullOrWhiteSpace(Name) || Name.Length > MaxNameLength || Name.Any(c => NotInNames.Contains(c)))
            yield return $"{nameof(Name)} is '{Name}'; it must be the beginning of a file name, 1 to {MaxNameLength} "
                + "characters without a folder";
        if (MaxFileBytes < MinFileBytes)
            yield return $"{nameof(MaxFileBytes)} is {MaxFileBytes}; it must be at least {MinFileBytes}";
        if (MaxFiles < 2)
            yield return $"{nameof(MaxFiles)} is {MaxFiles}; it must be at least 2";
        if (FramesWaiting < 1)
            yield return $"{nameof(FramesWaiting)} is {FramesWaiting}; it must be at least 1";
    }

    /// <summary>Finds out before the run whether the folder can be written.</summary>
    /// <exception cref="ArgumentException">It cannot.</exception>
    internal void CheckFolder(string parameter)
    {
        string probe = string.Empty;
        try
        {
            Directory.CreateDirectory(Folder);
            do
                probe = Path.Combine(Folder, $".{Name}-{Guid.NewGuid():N}");
            while (File.Exists(probe));
            File.WriteAllBytes(probe, new byte[1]);
            File.Delete(probe);
        }
        catch (Exception e)
            when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            TryDelete(probe);
            throw new ArgumentException(
                $"the folder of the recording, {Folder}, cannot be written: {e.Message.TrimEnd('.')}",
                parameter, e);
        }
    }

    private static void TryDelete(string probe)
    {
        try
        {
            File.Delete(probe);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException)
        {
            // What led here is reported.
        }
    }
}
