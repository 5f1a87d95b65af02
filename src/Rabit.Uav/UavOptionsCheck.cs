using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Communications;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Preflight;

namespace Rabit.Uav;

/// <summary>
/// Finds everything that is wrong with the options of a system and of its managers, so that one error names it all.
/// </summary>
internal static class UavOptionsCheck
{
    // Of a camera that looks down.
    private const double MaxDownPitchDegrees = -85;

    public static IReadOnlyList<string> FindFaults(UavOptions given)
    {
        var faults = new List<string>();

        // What is null is reported, and replaced by its default so that the rest can be checked too.
        UavOptions options = WithoutNulls(given, faults);
        faults.AddRange(UavLinkCheck.FindNulls(given));
        faults.AddRange(FindFaultsOfAddresses(options));
        faults.AddRange(UavLinkCheck.FindFaults(options));
        faults.AddRange(
            SubscriptionCheck.FindFaults(ManagerOptions.DialectOf(options), ManagerOptions.SubscriptionsOf(options)));
        faults.AddRange(FindFaultsOfManagers(options));
        faults.AddRange(FindFaultsOfWhatIsLeftOut(options));
        faults.AddRange(ManagerOptions.FindContradictions(options));
        faults.AddRange(FindFaultsOfParts(options));
        return faults;
    }

    private static UavOptions WithoutNulls(UavOptions given, List<string> faults)
    {
        UavOptions options = given.Copy();
        var defaults = new UavOptions();
        options.Communications = NotNull(given.Communications, defaults.Communications, nameof(given.Communications))
            .Copy();
        options.Autopilot = NotNull(given.Autopilot, defaults.Autopilot, nameof(given.Autopilot)).Copy();
        options.MissionControl = NotNull(given.MissionControl, defaults.MissionControl, nameof(given.MissionControl));
        options.Imaging = NotNull(given.Imaging, defaults.Imaging, nameof(given.Imaging));
        options.Fusion = NotNull(given.Fusion, defaults.Fusion, nameof(given.Fusion));
        options.Health = NotNull(given.Health, defaults.Health, nameof(given.Health));
        options.Preflight = NotNull(given.Preflight, defaults.Preflight, nameof(given.Preflight));
        options.LinkOptions = NotNull(given.LinkOptions, defaults.LinkOptions, nameof(given.LinkOptions));
        (options.Links, options.OpenLinks) = (UavLinkCheck.Usable(given.Links), UavLinkCheck.Usable(given.OpenLinks));
        options.OtherManagers = NoneIsNull(given.OtherManagers, nameof(given.OtherManagers));
        options.Dialect = NotNull(given.Dialect, defaults.Dialect, nameof(given.Dialect));
        options.Subscriptions = NoneIsNull(given.Subscriptions, nameof(given.Subscriptions));

        CommunicationsOptions communications = options.Communications;
        string place = nameof(given.Communications) + ".";
        communications.Dialect = NotNull(
            communications.Dialect, defaults.Dialect, place + nameof(communications.Dialect));
        communications.Subscriptions = NoneIsNull(
            communications.Subscriptions, place + nameof(communications.Subscriptions));
        options.Autopilot.Dialect = NotNull(
            options.Autopilot.Dialect, defaults.Dialect,
            nameof(given.Autopilot) + "." + nameof(options.Autopilot.Dialect));
        return options;

        T NotNull<T>(T? value, T standIn, string name)
            where T : class
        {
            if (value is null)
                faults.Add($"{name} is null");
            return value ?? standIn;
        }

        IReadOnlyList<T> NoneIsNull<T>(IReadOnlyList<T>? values, string name)
            where T : class
        {
            if (values?.Contains(null!) == true)
                faults.Add($"one of {name} is null");
            return NotNull(values, [], name).Where(v => v is not null).ToArray();
        }
    }

    private static IEnumerable<string> FindFaultsOfAddresses(UavOptions options)
    {
        if (options.SystemId == 0)
            yield return $"{nameof(options.SystemId)} is 0; it must be 1 to 255";
        if (options.ComponentId == 0)
            yield return $"{nameof(options.ComponentId)} is 0; it must be 1 to 255";
    }

    private static IEnumerable<string> FindFaultsOfManagers(UavOptions options)
    {
        if ((options.Without & ~UavManagers.All) != 0)
            yield return $"{nameof(options.Without)} is {options.Without:D}, which is none of the managers";
        IEnumerable<string> ours = AbsentManagers.Of(UavManagers.All & ~options.Without).Select(m => m.Name);
        foreach (IGrouping<string, string> same in ours.Concat(options.OtherManagers.Select(m => m.Name))
            .GroupBy(n => n, StringComparer.Ordinal).Where(g => g.Count() > 1))
            yield return $"{same.Count()} managers are named '{same.Key}'";

        MissionPlan? mission = ManagerOptions.MissionOf(options);
        if (mission is not null && !options.MayCommand)
            yield return $"there is a mission, but {nameof(options.MayCommand)} is false";
        if (options.MayCommand && options.IsReplay)
            yield return "nothing can be commanded in a replay";
        ImageProcessingOptions imaging = ManagerOptions.ForImageProcessing(options);
        if (mission is not null && options.Camera is not null && options.Has(UavManagers.ImageProcessing)
            && !imaging.TargetClasses.IsDefault)
        {
            string declared = string.Join(", ", imaging.TargetClasses.Select(c => c?.Name));
            foreach (TargetClassName name in mission.Targets.Where(n => imaging.TargetClasses.All(c => c?.Name != n)))
                yield return $"target {name} of the mission is no target class; there are {declared}";
            foreach (TargetClassName name in (mission.TargetMotions?.Keys ?? [])
                .Where(n => imaging.TargetClasses.All(c => c?.Name != n)))
                yield return $"targetMotions of the mission has {name}, which is no target class; there are {declared}";
        }

        if (mission is not null && FindGapBetweenLanes(mission, options) is { } gap)
            yield return gap;
        if (imaging.Detector is not null && options.Camera is null)
            yield return $"there is a {nameof(imaging.Detector)}, but no {nameof(options.Camera)} whose pictures it "
                + "could search";
        if (imaging.LandingMarker is not null && options.Camera is null)
            yield return $"there is a {nameof(imaging.LandingMarker)}, but no {nameof(options.Camera)} whose pictures "
                + "could show it";
    }

    /// <summary>Whether ground between the lanes would not be seen; null where that is not so.</summary>
    // What is wrong with the values by themselves is reported with them.
    public static string? FindGapBetweenLanes(MissionPlan mission, UavOptions options)
    {
        if (WidthOf(mission, options) is not { } width)
            return null;
        return mission.LaneSpacingMetres <= width
            ? null
            : $"laneSpacingMetres of the mission is {MissionNumbers.Of(mission.LaneSpacingMetres)}, wider than the "
                + $"picture: from heightMetres {MissionNumbers.Of(mission.HeightMetres)} the camera sees "
                + $"{MissionNumbers.Of(width)} m across the lanes, and the ground between them would not be seen";
    }

    /// <summary>
    /// How wide the strip is that a camera that looks down sees of a mission; null for others, and where a camera or
    /// mission with faults says nothing of it.
    /// </summary>
    public static double? SwathOf(MissionPlan mission, UavOptions options)
        => mission.CameraPitch.Degrees > MaxDownPitchDegrees ? null : WidthOf(mission, options);

    /// <summary>
    /// From forward of the vehicle to the longer side of a mission's pictures; null where there is none, the camera
    /// does not turn with the vehicle, or a camera or mission with faults says nothing of it.
    /// </summary>
    public static Angle? LongerSideOf(MissionPlan mission, UavOptions options)
    {
        ImageProcessingOptions imaging = ManagerOptions.ForImageProcessing(options);
        bool turnsWithVehicle = !mission.HasGimbal && imaging.Mount?.GimbalFrame != GimbalFrame.North;
        return turnsWithVehicle && IsViewKnown(mission, options, imaging)
            ? PictureSides.LongerSide(imaging.Camera!, imaging.Mount!, mission.CameraPitch, mission.CameraYaw)
            : null;
    }

    // How wide the ground is across the lanes that a picture shows.
    private static double? WidthOf(MissionPlan mission, UavOptions options)
    {
        ImageProcessingOptions imaging = ManagerOptions.ForImageProcessing(options);
        return IsViewKnown(mission, options, imaging)
            ? PictureSwath.WidthMetres(
                imaging.Camera!, imaging.Mount!, mission.CameraPitch, mission.CameraYaw, mission.HeightMetres)
            : null;
    }

    /// <summary>
    /// How large the smallest target of a mission is in its pictures; null where none is searched for, or a camera or
    /// mission with faults says nothing of it.
    /// </summary>
    public static SearchResolution? ResolutionOf(MissionPlan mission, UavOptions options)
    {
        ImageProcessingOptions imaging = ManagerOptions.ForImageProcessing(options);
        if (!IsViewKnown(mission, options, imaging) || TargetClass.FindFaults(imaging.TargetClasses).Any())
            return null;
        return SearchResolution.Of(
            imaging.Camera!, imaging.Mount!, mission.CameraPitch, mission.CameraYaw, mission.HeightMetres,
            imaging.EffectiveMinTargetPixels,
            imaging.TargetClasses.Where(c => mission.Targets.IsDefaultOrEmpty || mission.Targets.Contains(c.Name)));
    }

    /// <summary>What refuses a change of a mission after which no picture would be searched; null for others.</summary>
    public static string? FindTooCoarse(MissionPlan mission, UavOptions options)
        => options.MissionControl.Group is null && ResolutionOf(mission, options) is { IsTooCoarse: true } resolution
            ? $"heightMetres of the mission is too much for its smallest target: {resolution}"
            : null;

    private static bool IsViewKnown(MissionPlan mission, UavOptions options, ImageProcessingOptions imaging)
        => options.Camera is not null && options.Has(UavManagers.ImageProcessing)
            && imaging.Camera?.FindFaults().Any() == false && imaging.Mount?.FindFaults().Any() == false
            && !MissionPlanRules.FindFaults(mission).Any();

    private static IEnumerable<string> FindFaultsOfWhatIsLeftOut(UavOptions options)
    {
        if (ManagerOptions.MissionOf(options) is not null && !options.Has(UavManagers.MissionControl))
            yield return $"there is a mission, but {nameof(options.Without)} has {nameof(UavManagers.MissionControl)}";
        if (options.Camera is not null && !options.Has(UavManagers.ImageProcessing))
            yield return $"there is a camera, but {nameof(options.Without)} has {nameof(UavManagers.ImageProcessing)}";
        if (options.Has(UavManagers.Communications))
            yield break;
        if (options.Links.Count + options.OpenLinks.Count > 0)
            yield return $"there are links, but {nameof(options.Without)} has {nameof(UavManagers.Communications)}: "
                + "open them where your own manager is made";
        if (ManagerOptions.SigningOf(options) is not null || ManagerOptions.SubscriptionsOf(options).Count > 0
            || options.Communications.VehicleMessageRoutes is { Count: > 0 })
            yield return "signing, subscriptions and vehicle messages are the work of "
                + $"{nameof(UavManagers.Communications)}, which {nameof(options.Without)} has";
    }

    // Of the managers that are made; each of them checks again, for those who make it themselves.
    private static IEnumerable<string> FindFaultsOfParts(UavOptions options)
    {
        MissionControlOptions missionControl = ManagerOptions.ForMissionControl(options);
        (UavManagers Manager, string Name, IEnumerable<string> Faults)[] parts =
        [
            (UavManagers.Communications, "Communications", options.Communications.FindFaultsOfValues()),
            (UavManagers.AutopilotInterface, "Autopilot Interface", options.Autopilot.FindFaults()),
            (UavManagers.ImageProcessing, "Image Processing",
                ManagerOptions.ForImageProcessing(options).FindFaults(options.Camera is not null)),
            (UavManagers.SensorFusion, "Sensor Fusion", options.Fusion.FindFaults()),
            (UavManagers.MissionControl, "Mission Control", missionControl.FindFaults()),
            (UavManagers.HealthMonitoring, "Health Monitoring", options.Health.FindFaults()),
            (UavManagers.HealthMonitoring, nameof(options.Preflight), options.Preflight.FindFaults()),
        ];
        return parts.Where(p => options.Has(p.Manager)).SelectMany(p => p.Faults.Select(f => $"{p.Name}: {f}"));
    }
}
