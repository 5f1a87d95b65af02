using System;
using System.Collections.Generic;
using System.IO;
using Rabit.Uav.GroundControl;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;

namespace UavConsole;

/// <summary>What the operator asked for on the command line.</summary>
internal sealed class OperatorChoices
{
    private bool _isGiven;

    /// <summary>What a vehicle that flies already is commanded at the start; null for nothing.</summary>
    public OperatorCommand? AtStart { get; init; }

    /// <summary>Progress of an earlier flight; null for none.</summary>
    public string? ResumeFile { get; init; }

    /// <summary>Where the progress goes; null for nowhere.</summary>
    public string? ProgressFile { get; init; }

    /// <summary>Whether a mission is begun that the battery cannot fly to its end.</summary>
    public bool AllowsPartialSearch { get; init; }

    public OnStop OnStop { get; init; }

    /// <summary>Whether a bell rings at a target and at a failsafe.</summary>
    public bool HasBell { get; init; }

    /// <summary>System ids of those who may command the mission by MAVLink; empty where there are none.</summary>
    public IReadOnlyList<byte> Commanders { get; init; } = [];

    /// <summary>Whether their commands must be signed.</summary>
    public bool OnlySigned { get; init; }

    /// <summary>Whether ground stations get confirmed targets as traffic too.</summary>
    public bool SendsTargetsAsTraffic { get; init; }

    /// <summary>Whether the autopilot's fence is offered as another area when others have changed it.</summary>
    public bool OffersFence { get; init; }

    /// <summary>Radius of the circles of a fixed wing; null where none is commanded.</summary>
    public double? LoiterRadiusMetres { get; init; }

    /// <summary>As the configuration file says, where the command line says nothing of it; null for none.</summary>
    public GroundCommandOptions? Configured { get; init; }

    /// <summary>Who may command the mission by MAVLink; null where there is none.</summary>
    public GroundCommandOptions? GroundCommands
        => Configured ?? GivenCommands;

    private GroundCommandOptions? GivenCommands
        => Commanders.Count == 0 && !OffersFence ? null : new GroundCommandOptions
        {
            SystemIds = Commanders,
            OnlySigned = OnlySigned,
            OffersAutopilotFence = OffersFence,
        };

    /// <summary>Sets the options of Mission Control.</summary>
    /// <exception cref="ArgumentException">A file cannot be read, or is damaged.</exception>
    public void ApplyTo(MissionControlOptions options)
    {
        options.OnStop = OnStop;
        if (LoiterRadiusMetres is { } radius)
            options.FixedWing = new FixedWingOptions { LoiterRadiusMetres = radius };
        options.AllowsPartialSearch = AllowsPartialSearch;
        if (ResumeFile is { } resume)
            options.Resume = Read(resume);

        // A start that only brings a vehicle home leaves the progress of its mission as it is.
        options.ProgressFile = AtStart is null ? ProgressFile : null;
    }

    /// <summary>
    /// Keeps a copy of the progress of another flight; once nothing prevents the start. The file itself stays until
    /// this flight has progress of its own: a start that does not fly must not take it away from --resume and
    /// --return-if-abandoned.
    /// </summary>
    /// <exception cref="ArgumentException">It cannot be kept, or the new one cannot be written.</exception>
    public void KeepEarlierProgress()
    {
        bool isResumed = ResumeFile is { } from && ProgressFile is { } to
            && string.Equals(Path.GetFullPath(from), Path.GetFullPath(to), StringComparison.Ordinal);
        if (ProgressFile is not { } progress || AtStart is not null)
            return;
        OutputPath.CheckReplaced("--progress", progress);
        if (!isResumed)
            KeepTheOldOne(progress);
    }

    /// <summary>Gives the command of the start, once, when the vehicle turns out to fly already.</summary>
    /// <param name="phase">The phase of the mission.</param>
    /// <param name="missionControl">Takes the command.</param>
    public void Update(MissionPhase phase, MissionControlManager missionControl)
    {
        if (_isGiven || AtStart is not { } command || phase != MissionPhase.HandedOver)
            return;
        _isGiven = true;
        missionControl.Give(new OperatorRequest(
            command, "command line", command == OperatorCommand.Hold ? "--hold" : "--return"));
    }

    private static MissionProgress Read(string path)
    {
        try
        {
            return MissionProgress.ReadFile(path);
        }
        catch (Exception e)
            when (e is MissionProgressException or IOException or UnauthorizedAccessException or NotSupportedException)
        {
            throw new ArgumentException("--resume: " + e.Message, nameof(path), e);
        }
    }

    private static void KeepTheOldOne(string path)
    {
        try
        {
            DatedFile.KeepCopy(path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException)
        {
            throw new ArgumentException($"--progress {path} cannot be written: {e.Message}", nameof(path), e);
        }
    }
}
