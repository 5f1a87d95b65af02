using System;
using System.Collections.Immutable;
using System.Globalization;
using System.Threading;
using Rabit.Geodesy;

namespace Rabit.Uav.Messages;

/// <summary>
/// A command of the operator: what, by whom and why, and what became of it. Mission Control answers each one, once; any
/// thread may ask for the answer.
/// </summary>
/// <example>
/// <code>
/// OperatorRequest request = uav.MissionControl.Hold("console", "a walker below");
/// // later
/// if (request.Outcome == OperatorOutcome.Refused)
///     Console.WriteLine($"{request.Name} refused: {request.Answer}");
/// </code>
/// </example>
public sealed class OperatorRequest
{
    private Answered? _answer; // written once by Mission Control, read by any thread

    /// <summary>Makes a request.</summary>
    /// <param name="command">What to do.</param>
    /// <param name="by">Who commands, for the log: "console", say.</param>
    /// <param name="reason">Why, as text for the status and the log.</param>
    /// <exception cref="ArgumentException">
    /// The command is none of its values, or there is no name or no reason.
    /// </exception>
    public OperatorRequest(OperatorCommand command, string by, string reason)
    {
        if (command is < OperatorCommand.Hold or > OperatorCommand.OfferArea)
            throw new ArgumentException($"The command is {command:D}, which is none of its values.", nameof(command));
        if (string.IsNullOrWhiteSpace(by))
            throw new ArgumentException("The operator's command needs a name of who gives it.", nameof(by));
        if (string.IsNullOrWhiteSpace(reason))
            throw new ArgumentException("The operator's command needs a reason.", nameof(reason));
        (Command, By, Reason) = (command, by, reason);
    }

    /// <summary>What to do.</summary>
    public OperatorCommand Command { get; }

    /// <summary>Who commands.</summary>
    public string By { get; }

    /// <summary>Why.</summary>
    public string Reason { get; }

    /// <summary>The track to revisit, to confirm or to reject.</summary>
    public int TrackId { get; init; }

    /// <summary>The place to fly over; its altitude is not used.</summary>
    public GeodeticPosition Place { get; init; }

    /// <summary>The speed to fly at, over ground.</summary>
    public double SpeedMetresPerSecond { get; init; }

    /// <summary>The value to set.</summary>
    public MissionParameter Parameter { get; init; }

    /// <summary>What it is set to.</summary>
    public double Value { get; init; }

    /// <summary>Corners of the area that is offered; altitudes are not used.</summary>
    public ImmutableArray<GeodeticPosition> Area { get; init; } = [];

    /// <summary>The keep-outs of that area.</summary>
    public ImmutableArray<ImmutableArray<GeodeticPosition>> KeepOuts { get; init; } = [];

    /// <summary>What became of it.</summary>
    public OperatorOutcome Outcome => Volatile.Read(ref _answer)?.Outcome ?? OperatorOutcome.InProgress;

    /// <summary>Why it was refused, or what was done; empty where there is nothing to say.</summary>
    public string Answer => Volatile.Read(ref _answer)?.Text ?? string.Empty;

    /// <summary>The command with what belongs to it, as text: "revisit track 3".</summary>
    public string Name => Command switch
    {
        OperatorCommand.SkipLane => "skip lane",
        OperatorCommand.Revisit or OperatorCommand.Confirm or OperatorCommand.Reject
            => Verb + " track " + TrackId.ToString(CultureInfo.InvariantCulture),
        OperatorCommand.RevisitPlace => string.Format(
            CultureInfo.InvariantCulture, "revisit {0:0.00000}, {1:0.00000}", Place.Latitude.Degrees,
            Place.Longitude.Degrees),
        OperatorCommand.ChangeSpeed
            => string.Format(CultureInfo.InvariantCulture, "change speed to {0:0.0#} m/s", SpeedMetresPerSecond),
        OperatorCommand.ChangeParameter
            => string.Format(CultureInfo.InvariantCulture, "set {0} to {1:0.####}", Parameter, Value),
        OperatorCommand.OfferArea => Area.IsDefaultOrEmpty ? "withdraw the area" : string.Format(
            CultureInfo.InvariantCulture, "offer an area of {0} corners with {1} keep-outs", Area.Length,
            KeepOuts.IsDefault ? 0 : KeepOuts.Length),
        _ => Verb,
    };

    private string Verb => Command.ToString().ToLowerInvariant();

    /// <summary>Answers it; the first answer counts.</summary>
    internal void Set(OperatorOutcome outcome, string text)
        => Interlocked.CompareExchange(ref _answer, new Answered(outcome, text), null);

    private sealed class Answered(OperatorOutcome outcome, string text)
    {
        public OperatorOutcome Outcome { get; } = outcome;

        public string Text { get; } = text;
    }
}
