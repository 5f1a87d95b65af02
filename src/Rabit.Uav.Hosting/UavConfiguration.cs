using System;
using System.Collections.Generic;
using System.Linq;
using Microsoft.Extensions.Configuration;
using Rabit.Links;
using Rabit.Uav.Communications;
using Rabit.Uav.ImageProcessing;
using Rabit.Vision;

namespace Rabit.Uav.Hosting;

/// <summary>
/// Reads <see cref="UavOptions"/> from a section of a configuration. A setting has the name of its property:
/// <c>Health:BatteryLowFraction</c> is <see cref="UavOptions.Health"/>.BatteryLowFraction. Times are written as
/// 00:00:02.5, angles in degrees, lists with one key for each item; mission, terrain, camera and keys are files.
/// </summary>
public static class UavConfiguration
{
    /// <summary>The section of a configuration that says what the companion computer is made of.</summary>
    public const string Section = "Uav";

    private const string Camera = nameof(UavOptions.Camera);
    private const string Signing = nameof(UavOptions.Signing);
    private const string UploadsFence = "UploadsFence";

    // The options of the managers, and their names in faults and in the configuration.
    private static readonly (string Name, string Key)[] Parts =
    [
        ("Communications", nameof(UavOptions.Communications)),
        ("Autopilot Interface", nameof(UavOptions.Autopilot)),
        ("Image Processing", nameof(UavOptions.Imaging)),
        ("Sensor Fusion", nameof(UavOptions.Fusion)),
        ("Mission Control", nameof(UavOptions.MissionControl)),
        ("Health Monitoring", nameof(UavOptions.Health)),
        ("Preflight", nameof(UavOptions.Preflight)),
    ];

    /// <summary>Sets what a section says; the rest stays as it is. Files that it names are read.</summary>
    /// <param name="section">For example "Uav" of appsettings.json.</param>
    /// <param name="options">Takes the settings.</param>
    /// <returns>
    /// A line, with the path of the key, for each setting that is not known or cannot be used; empty where all was
    /// set. What a value may be is checked by <see cref="FindFaults"/>.
    /// </returns>
    public static IReadOnlyList<string> Apply(IConfigurationSection section, UavOptions options)
    {
        _ = section ?? throw new ArgumentNullException(nameof(section));
        _ = options ?? throw new ArgumentNullException(nameof(options));
        var faults = new List<string>();
        OptionsBinder.Apply(section, options, [Camera, Signing, UploadsFence], faults);
        ReadCamera(section.GetSection(Camera), options, faults);
        ReadSigning(section.GetSection(Signing), options, faults);
        ReadFence(section.GetSection(UploadsFence), options, faults);
        return faults;
    }

    /// <summary>What is wrong with options, each fault with the path of its key where it is that of one.</summary>
    /// <param name="section">Its path is that of the keys.</param>
    /// <param name="options">As they were read.</param>
    public static IReadOnlyList<string> FindFaults(IConfigurationSection section, UavOptions options)
    {
        _ = section ?? throw new ArgumentNullException(nameof(section));
        _ = options ?? throw new ArgumentNullException(nameof(options));
        return options.FindFaults().Select(f => section.Path + ":" + WithKey(f)).ToArray();
    }

    private static string WithKey(string fault)
    {
        foreach ((string name, string key) in Parts)
        {
            if (fault.StartsWith(name + ": ", StringComparison.Ordinal))
                return $"{key}:{fault.Substring(name.Length + 2)}";
        }

        return char.IsUpper(fault[0]) && fault.IndexOf(' ') is var end and > 0 && OptionsBinder.Has(
            typeof(UavOptions), fault.Substring(0, end))
            ? fault
            : " " + fault;
    }

    private static void ReadCamera(IConfigurationSection setting, UavOptions options, List<string> faults)
    {
        if (OptionsBinder.TextOf(setting, faults) is not { } path)
            return;
        try
        {
            CameraFolder folder = CameraFolder.Open(path);
            options.Camera = folder.CreateCamera();
            (options.Imaging.Camera, options.Imaging.Mount) = (folder.Camera, folder.Mount);
        }
        catch (PictureException e)
        {
            faults.Add($"{setting.Path}: {e.Message}");
        }
    }

    private static void ReadSigning(IConfigurationSection section, UavOptions options, List<string> faults)
    {
        var settings = new SigningSettings();
        int before = faults.Count;
        OptionsBinder.Apply(section, settings, [], faults);
        if (!section.Exists() || faults.Count > before)
            return;
        if (settings.KeyFile is not { } file)
        {
            faults.Add($"{section.Path}:{nameof(settings.KeyFile)} is missing: the file of the key");
            return;
        }

        int live = options.OpenLinks.Count + options.Links.Count(l => l.Kind != LinkKind.RecordedFile);
        faults.AddRange(settings.TrustedLinks.Where(l => l < 0 || l >= live).Select(
            l => FormattableString.Invariant(
                $"{section.Path}:{nameof(settings.TrustedLinks)} has {l}; there are {live} live links, from 0")));
        try
        {
            options.Signing = new SigningOptions(SigningKeyFile.Read(file))
            {
                Links = Enumerable.Range(0, live).Except(settings.TrustedLinks).ToArray(),
                TimestampStore = new FileTimestampStore(file + ".clock"),
            };
        }
        catch (Exception e) when (OptionsBinder.IsBadInput(e))
        {
            faults.Add($"{section.Path}:{nameof(settings.KeyFile)}: {OptionsBinder.SentenceOf(e)}");
        }
    }

    private static void ReadFence(IConfigurationSection setting, UavOptions options, List<string> faults)
    {
        if (OptionsBinder.TextOf(setting, faults) is not { } text)
            return;
        if (!bool.TryParse(text, out bool uploads))
            faults.Add($"{setting.Path} is '{text}'; it must be true or false");
        else if (uploads && options.Mission is null)
            faults.Add($"{setting.Path} is true, but there is no {nameof(options.Mission)} whose fence it could be");
        else if (uploads)
        {
            options.Autopilot.Setup.Fence = options.Mission!.AutopilotFence;
            options.Autopilot.Setup.KeepOuts = options.Mission.KeepOuts.Select(k => k.ToArray()).ToArray();
        }
    }

    private sealed class SigningSettings
    {
        public string? KeyFile { get; set; }

        public IReadOnlyList<int> TrustedLinks { get; set; } = [];
    }
}
