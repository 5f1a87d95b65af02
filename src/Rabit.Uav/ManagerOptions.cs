using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Links;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Communications;
using Rabit.Uav.GroundControl;
using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.SensorFusion;

namespace Rabit.Uav;

/// <summary>
/// Joins what the options of a system and those of its managers say of the same thing. What only one of them sets
/// holds; where both set it and differ, that is a fault with the names of both.
/// </summary>
internal static class ManagerOptions
{
    // What the gimbal reports of itself is worth more than what it was pointed by.
    private static readonly RequestedRate GimbalRate = new(GimbalDeviceAttitudeStatus.MavlinkId, 10);

    // PX4 takes a landing target in the frame that this is in.
    private static readonly RequestedRate LocalPositionRate = new(LocalPositionNed.MavlinkId, 20);

    public static IEnumerable<string> FindContradictions(UavOptions options)
    {
        CommunicationsOptions communications = options.Communications;
        AutopilotOptions autopilot = options.Autopilot;
        string?[] contradictions =
        [
            Contradiction(
                nameof(UavOptions.Signing), options.Signing, Of(nameof(communications.Signing)), communications.Signing,
                null),
            Contradiction(
                nameof(UavOptions.Dialect), options.Dialect, Of(nameof(communications.Dialect)), communications.Dialect,
                MavlinkDialect.All, d => d!.Name),
            Contradiction(
                nameof(UavOptions.Dialect), options.Dialect, OfAutopilot(nameof(autopilot.Dialect)), autopilot.Dialect,
                MavlinkDialect.All, d => d!.Name),
            Contradiction(
                nameof(UavOptions.SystemId), options.SystemId, OfAutopilot(nameof(autopilot.SystemId)),
                autopilot.SystemId, null),
            Contradiction(
                nameof(UavOptions.ComponentId), options.SetComponentId, OfAutopilot(nameof(autopilot.ComponentId)),
                autopilot.SetComponentId, null),
            Contradiction(
                nameof(UavOptions.Mission), options.Mission,
                nameof(UavOptions.MissionControl) + "." + nameof(MissionControlOptions.Mission),
                options.MissionControl.Mission, null),
            Contradiction(
                nameof(UavOptions.Terrain), options.Terrain,
                nameof(UavOptions.MissionControl) + "." + nameof(MissionControlOptions.Terrain),
                options.MissionControl.Terrain, null),
            Contradiction(
                nameof(UavOptions.Terrain), options.Terrain,
                nameof(UavOptions.Imaging) + "." + nameof(ImageProcessingOptions.Terrain),
                options.Imaging.Terrain, null),
        ];
        foreach (string contradiction in contradictions.OfType<string>())
            yield return contradiction;

        if (MissionOf(options) is { TargetMotions: { } motions } && options.Fusion.TargetMotions is { } ofFusion)
        {
            foreach (TargetClassName name in motions.Keys
                .Where(n => ofFusion.TryGetValue(n, out TargetMotion other) && other != motions[n])
                .OrderBy(n => n.ToString(), StringComparer.Ordinal))
            {
                yield return $"targetMotions of the mission has {name} {motions[name]}, and "
                    + $"{nameof(UavOptions.Fusion)}.{nameof(SensorFusionOptions.TargetMotions)} {ofFusion[name]}";
            }
        }

        if (communications.Links is not { Count: 0 } || communications.RecordedFiles is not { Count: 0 })
        {
            yield return $"{Of(nameof(communications.Links))} and {Of(nameof(communications.RecordedFiles))} are what "
                + $"is opened from {nameof(UavOptions.Links)} "
                + $"and {nameof(UavOptions.OpenLinks)}; leave them empty";
        }

        if (options.MissionControl.FixedWing is not null && autopilot.Setup is { Writes: true })
        {
            yield return $"{OfAutopilot(nameof(autopilot.Setup))} writes failsafes or a fence, which are not known of "
                + $"{nameof(UavOptions.MissionControl)}.{nameof(MissionControlOptions.FixedWing)}";
        }

        if (autopilot.MayCommand && !options.MayCommand)
            yield return $"{OfAutopilot(nameof(autopilot.MayCommand))} is true, but {nameof(UavOptions.MayCommand)} is "
                + "false";
    }

    public static SigningOptions? SigningOf(UavOptions options) => options.Signing ?? options.Communications.Signing;

    /// <summary>The mission as it is flown.</summary>
    public static MissionPlan? MissionOf(UavOptions options) => options.MissionControl.InLayer(GivenMissionOf(options));

    private static MissionPlan? GivenMissionOf(UavOptions options) => options.Mission ?? options.MissionControl.Mission;

    public static MavlinkDialect DialectOf(UavOptions options)
        => !ReferenceEquals(options.Dialect, MavlinkDialect.All) ? options.Dialect
        : !ReferenceEquals(options.Communications.Dialect, MavlinkDialect.All) ? options.Communications.Dialect
        : options.Autopilot.Dialect;

    public static IReadOnlyList<MavlinkSubscription> SubscriptionsOf(UavOptions options)
        => options.Subscriptions.Concat(options.Communications.Subscriptions)
            .Concat(HasGroundCommands(options) ? [GroundCommandManager.CreateSubscription()] : [])
            .ToArray();

    public static bool HasGroundCommands(UavOptions options)
        => options.GroundCommands is not null && options.Has(UavManagers.Communications)
            && options.Has(UavManagers.MissionControl);

    public static CommunicationsOptions ForCommunications(
        UavOptions options, IReadOnlyList<IByteLink> links, IReadOnlyList<RecordedFile> files,
        IReadOnlyDictionary<int, MavlinkSigningKey>? linkKeys = null)
    {
        CommunicationsOptions made = options.Communications.Copy();
        made.Links = links;
        made.RecordedFiles = files;
        made.StopsWhenAllLinksEnd |= options.IsReplay;
        made.Signing = SigningOptions.With(
            SigningOf(options), linkKeys ?? new Dictionary<int, MavlinkSigningKey>());
        made.LinkSettings = LinkSettingsOf(options);
        made.Dialect = DialectOf(options);
        made.Subscriptions = SubscriptionsOf(options);
        made.SendsTargets ??= options.Has(UavManagers.SensorFusion);
        made.VehicleMessageRoutes = [.. VehicleRoutes.Of(options), .. options.Communications.VehicleMessageRoutes];
        return made;
    }

    /// <summary>The settings of the links by their numbers: live ones first, then logs; a URL says more.</summary>
    public static IReadOnlyDictionary<int, LinkSettings> LinkSettingsOf(UavOptions options)
    {
        Dictionary<int, LinkSettings> settings = options.Communications.LinkSettings
            .ToDictionary(s => s.Key, s => s.Value);
        int number = options.OpenLinks.Count;
        foreach (LinkUrl url in options.Links.OrderBy(l => l.Kind == LinkKind.RecordedFile))
        {
            if (!ReferenceEquals(url.Settings, LinkSettings.None))
                settings[number] = url.Settings;
            number++;
        }

        return settings;
    }

    public static AutopilotOptions ForAutopilot(UavOptions options)
    {
        AutopilotOptions made = options.Autopilot.Copy();
        made.SystemId ??= options.SystemId;
        if (options.SetComponentId is { } componentId)
            made.ComponentId = componentId;
        made.RequestsRates &= options.RequestsMessageRates && !options.IsReplay;
        made.MayCommand = options.MayCommand;
        made.MayCommandFixedWing |= options.MissionControl.FixedWing is not null;
        made.Dialect = DialectOf(options);
        made.WatchesFence |= HasGroundCommands(options) && options.GroundCommands!.OffersAutopilotFence
            && made.RequestsRates;
        made.Setup = made.Setup.Copy();
        made.Setup.ReadsParameters |= ChecksBeforeFlight(options);
        if ((MissionOf(options) is { HasGimbal: true } || options.Imaging.Mount.GimbalFrame != GimbalFrame.Body)
            && made.RequestedRates.All(r => r.MessageId != GimbalDeviceAttitudeStatus.MavlinkId))
            made.RequestedRates = [.. made.RequestedRates, GimbalRate];
        made.SendsLandingTarget |= options.Imaging.LandingMarker is not null;
        made.SendsLandingTarget &= !options.IsReplay;
        if (made.SendsLandingTarget && made.RequestedRates.All(r => r.MessageId != LocalPositionNed.MavlinkId))
            made.RequestedRates = [.. made.RequestedRates, LocalPositionRate];
        return made;
    }

    public static ImageProcessingOptions ForImageProcessing(UavOptions options)
    {
        ImageProcessingOptions made = options.Imaging.Copy();
        made.Terrain ??= options.Terrain;
        if (MissionOf(options) is { TargetClasses.IsDefaultOrEmpty: false } mission && !made.TargetClasses.IsDefault)
        {
            made.TargetClasses =
            [
                .. made.TargetClasses.Where(c => mission.TargetClasses.All(own => own?.Name != c?.Name)),
                .. mission.TargetClasses,
            ];
        }

        return made;
    }

    public static SensorFusionOptions ForSensorFusion(UavOptions options)
    {
        SensorFusionOptions made = MissionOf(options) is { TargetMotions.IsEmpty: false } mission
            ? options.Fusion.With(mission.TargetMotions)
            : options.Fusion;
        return VehicleRoutes.HaveTracks(options) ? made.WithSharedTracks() : made;
    }

    public static MissionControlOptions ForMissionControl(UavOptions options)
    {
        MissionControlOptions made = options.MissionControl.Copy();
        made.Mission = GivenMissionOf(options);
        made.RequiresPreflight |= ChecksBeforeFlight(options);
        made.GimbalFrame = options.Imaging.Mount.GimbalFrame;
        made.Terrain ??= options.Terrain;
        made.ReturnClearanceMetres = options.Preflight.MinObstacleClearanceMetres;
        made.FindsFaultOfChange = changed => UavOptionsCheck.FindGapBetweenLanes(changed, options)
            ?? UavOptionsCheck.FindTooCoarse(changed, options);
        made.LongerSideOfPicture = MissionOf(options) is { } mission
            ? UavOptionsCheck.LongerSideOf(mission, options)
            : null;
        made.SwathMetres = flown => UavOptionsCheck.SwathOf(flown, options);
        return made;
    }

    public static HealthOptions ForHealth(UavOptions options, RabitTime time)
    {
        HealthOptions made = options.Health.Copy();
        made.Computer = options.Computer;
        if (time is RealTime && !options.IsReplay)
            made.Computer ??= new LinuxComputer(made.DataDirectory);
        if (MissionOf(options) is { } flown)
            made.GroundStationLoss = flown.GroundStationLost;
        made.WatchesRecording = options.Communications.Recording is not null && !options.IsReplay
            && options.Has(UavManagers.Communications);
        made.CameraManager = ImageProcessingManager.ManagerName;
        if (MissionOf(options) is not { } mission || !ChecksBeforeFlight(options))
            return made;
        made.Preflight = options.Preflight.Copy();
        made.Preflight.ObstacleHeightMetres ??= mission.ObstacleHeightMetres;
        made.Preflight.MaxReturnHeightMetres = mission.HeightMetres + options.MissionControl.Group?.SpareMetres;
        made.Preflight.Terrain = options.MissionControl.Terrain ?? options.Terrain;
        (made.Preflight.SearchArea, made.Preflight.FenceMarginMetres) = (mission.Area, mission.FenceMarginMetres);
        made.Preflight.MinBatteryFraction = mission.MinBatteryFractionAtStart;
        made.Preflight.AllowsUnknownBattery = mission.AllowUnknownBattery;
        made.Preflight.RequiresCamera = options.MissionControl.RequiresCamera;
        made.Preflight.IsInGroup = options.MissionControl.Group is not null;
        made.Preflight.Resolution = UavOptionsCheck.ResolutionOf(mission, options);
        return made;
    }

    // Where Health Monitoring is another's, the checklist is too.
    private static bool ChecksBeforeFlight(UavOptions options)
        => options.Preflight.IsRequired && MissionOf(options) is not null && !options.IsReplay
            && options.Has(UavManagers.HealthMonitoring) && options.Has(UavManagers.AutopilotInterface);

    private static string Of(string name) => nameof(UavOptions.Communications) + "." + name;

    private static string OfAutopilot(string name) => nameof(UavOptions.Autopilot) + "." + name;

    private static string? Contradiction<T>(
        string name, T value, string managerName, T managerValue, T unset, Func<T, string?>? describe = null)
    {
        EqualityComparer<T> comparer = EqualityComparer<T>.Default;
        if (comparer.Equals(value, unset) || comparer.Equals(managerValue, unset)
            || comparer.Equals(value, managerValue))
            return null;
        return typeof(T).IsValueType || describe is not null
            ? $"{name} is {Text(value)}, but {managerName} is {Text(managerValue)}; set one of them"
            : $"{name} and {managerName} are set, and differ; set one of them";

        string? Text(T of) => describe is null ? of?.ToString() : $"'{describe(of)}'";
    }
}
