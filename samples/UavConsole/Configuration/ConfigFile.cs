using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.Json;
using Microsoft.Extensions.Configuration;
using Rabit.Links;
using Rabit.Uav;
using Rabit.Uav.Hosting;

namespace UavConsole;

/// <summary>
/// A configuration file as a service of Rabit.Uav.Hosting has it: its section "Uav", less what the command line says
/// instead. One thread.
/// </summary>
internal sealed class ConfigFile
{
    private const string UploadsFenceKey = "UploadsFence";

    private readonly IConfigurationSection _section;

    private ConfigFile(string path, IConfigurationSection section, UavOptions options, bool uploadsFence)
        => (Path, _section, Options, UploadsFence) = (path, section, options, uploadsFence);

    public string Path { get; }

    /// <summary>As the file has them; the flight goes on from there.</summary>
    public UavOptions Options { get; }

    /// <summary>
    /// Whether the area of the mission is uploaded as the autopilot's fence, whichever mission that is.
    /// </summary>
    public bool UploadsFence { get; }

    /// <summary>Reads a file.</summary>
    /// <param name="path">Of the file.</param>
    /// <param name="isUsed">Whether a key of the section, as Health:BatteryLowFraction, counts.</param>
    /// <param name="links">Of the command line; empty where those of the file are used.</param>
    /// <param name="faults">Takes what is wrong with it, by file and key.</param>
    /// <returns>Null where it cannot be used.</returns>
    public static ConfigFile? Read(
        string path, Func<string, bool> isUsed, IReadOnlyList<LinkUrl> links, List<string> faults)
    {
        if (TryParse(path, out string? fault) is not { } values)
        {
            faults.Add(fault!);
            return null;
        }

        string prefix = UavConfiguration.Section + ":";
        KeyValuePair<string, string?>[] ours = values
            .Where(v => v.Key.StartsWith(prefix, StringComparison.OrdinalIgnoreCase)).ToArray();
        if (ours.Length == 0)
        {
            faults.Add($"--config {path} has no section {UavConfiguration.Section}, or nothing in it.");
            return null;
        }

        bool uploadsFence = ours.Any(v => IsUploadsFence(v) && bool.Parse(v.Value!));
        IConfigurationSection section = new ConfigurationBuilder()
            .AddInMemoryCollection(ours.Where(v => isUsed(v.Key.Substring(prefix.Length)) && !IsUploadsFence(v)))
            .Build().GetSection(UavConfiguration.Section);
        var options = new UavOptions { Links = links };
        int before = faults.Count;
        faults.AddRange(UavConfiguration.Apply(section, options).Select(f => $"{path}: {f}."));
        if (options.Without != UavManagers.None)
            faults.Add(
                $"{path}: {prefix}{nameof(options.Without)}: UavConsole shows all six managers; none is left out.");
        return faults.Count == before ? new ConfigFile(path, section, options, uploadsFence) : null;
    }

    /// <summary>The text of a key of the section; null where it has none.</summary>
    public string? TextOf(string key) => _section[key];

    /// <summary>How a key is named in errors.</summary>
    public string NameOf(string key) => $"{Path}: {_section.Path}:{key}";

    /// <summary>Checks the options of the flight.</summary>
    /// <exception cref="ArgumentException">Some are wrong; all are named.</exception>
    public void Check(UavOptions options)
    {
        IReadOnlyList<string> faults = UavConfiguration.FindFaults(_section, options);
        if (faults.Count > 0)
            throw new ArgumentException($"{Path}: {string.Join("; ", faults)}.", nameof(options));
    }

    // Of a mission, which the command line may give.
    private static bool IsUploadsFence(KeyValuePair<string, string?> value)
        => string.Equals(
            value.Key, $"{UavConfiguration.Section}:{UploadsFenceKey}", StringComparison.OrdinalIgnoreCase)
            && bool.TryParse(value.Value, out _);

    private static KeyValuePair<string, string?>[]? TryParse(string path, out string? fault)
    {
        fault = null;
        try
        {
            using var stream = new MemoryStream(Encoding.UTF8.GetBytes(TextFile.Read(path)));
            return new ConfigurationBuilder().AddJsonStream(stream).Build().AsEnumerable().ToArray();
        }
        catch (Exception e)
            when (e is IOException or UnauthorizedAccessException or NotSupportedException or ArgumentException)
        {
            fault = $"--config {path} cannot be read: {e.Message}";
        }
        catch (Exception e) when (e is FormatException or JsonException or InvalidDataException)
        {
            fault = $"--config {path}: {SentenceOf(e)}";
        }

        return null;
    }

    // Its own text counts lines from 0.
    private static string SentenceOf(Exception e)
        => e is JsonException { LineNumber: { } line }
            ? FormattableString.Invariant($"line {line + 1}: ")
                + e.Message.Split([" LineNumber:"], StringSplitOptions.None)[0]
            : e.Message;
}
