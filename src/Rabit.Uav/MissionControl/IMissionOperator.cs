using System.Collections.Immutable;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// What the operator can command a mission. Each method returns at once, any thread may call it, and requests are
/// carried out in the order in which they come. Each is answered: <see cref="OperatorRequest.Outcome"/>; the log says
/// who commanded what, and what became of it.
/// </summary>
/// <example>
/// <code>
/// IMissionOperator op = uav.MissionControl;
/// OperatorRequest hold = op.Hold("console", "key h");
/// OperatorRequest revisit = op.Revisit(3, "console", "is it a tent?");
/// </code>
/// </example>
public interface IMissionOperator
{
    /// <summary>Holds the position until the next command. Before take-off: gives the mission up.</summary>
    /// <param name="by">Who commands, for the log.</param>
    /// <param name="reason">Why, as text for the status and the log.</param>
    OperatorRequest Hold(string by, string reason);

    /// <summary>Returns to launch and lands there. Before take-off: gives the mission up.</summary>
    /// <inheritdoc cref="Hold" path="/param"/>
    OperatorRequest ReturnToLaunch(string by, string reason);

    /// <summary>Continues the mission where it was interrupted.</summary>
    /// <inheritdoc cref="Hold" path="/param"/>
    OperatorRequest ContinueMission(string by, string reason);

    /// <summary>Lands at the present position. Before take-off: gives the mission up.</summary>
    /// <inheritdoc cref="Hold" path="/param"/>
    OperatorRequest Land(string by, string reason);

    /// <summary>Leaves out what remains of the lane, or the next lane; gaps of that lane are not flown over.</summary>
    /// <inheritdoc cref="Hold" path="/param"/>
    OperatorRequest SkipLane(string by, string reason);

    /// <summary>Revisits a target now, and continues the search after that.</summary>
    /// <param name="trackId">Its track.</param>
    /// <param name="by">Who commands, for the log.</param>
    /// <param name="reason">Why, as text for the status and the log.</param>
    OperatorRequest Revisit(int trackId, string by, string reason);

    /// <summary>Flies over a place now, and continues the search after that.</summary>
    /// <param name="place">The place; its altitude is not used.</param>
    /// <param name="by">Who commands, for the log.</param>
    /// <param name="reason">Why, as text for the status and the log.</param>
    OperatorRequest RevisitPlace(GeodeticPosition place, string by, string reason);

    /// <summary>A target is what it seems to be: it stays confirmed.</summary>
    /// <inheritdoc cref="Revisit" path="/param"/>
    OperatorRequest Confirm(int trackId, string by, string reason);

    /// <summary>A target is none: it is neither revisited nor reported as confirmed.</summary>
    /// <inheritdoc cref="Revisit" path="/param"/>
    OperatorRequest Reject(int trackId, string by, string reason);

    /// <summary>Flies at another speed from now on.</summary>
    /// <param name="metresPerSecond">Over ground, 0.5 to 20.</param>
    /// <param name="by">Who commands, for the log.</param>
    /// <param name="reason">Why, as text for the status and the log.</param>
    OperatorRequest ChangeSpeed(double metresPerSecond, string by, string reason);

    /// <summary>Sets a value of the mission, from the next leg on.</summary>
    /// <param name="parameter">Which one.</param>
    /// <param name="value">What it is set to.</param>
    /// <param name="by">Who commands, for the log.</param>
    /// <param name="reason">Why, as text for the status and the log.</param>
    OperatorRequest ChangeParameter(MissionParameter parameter, double value, string by, string reason);

    /// <summary>
    /// Offers another area, in place of one that was offered before: the next <see cref="ContinueMission"/>, in
    /// whatever phase, takes it over, and what was seen of it already is not flown again. It is planned beside the
    /// flight before it is answered, which may take some seconds.
    /// </summary>
    /// <param name="area">Its corners in order; none to withdraw what was offered.</param>
    /// <param name="keepOuts">Its keep-outs, all of them.</param>
    /// <param name="by">Who commands, for the log.</param>
    /// <param name="reason">Why, as text for the status and the log.</param>
    OperatorRequest OfferArea(
        ImmutableArray<GeodeticPosition> area, ImmutableArray<ImmutableArray<GeodeticPosition>> keepOuts, string by,
        string reason);

    /// <summary>
    /// The mission with all changes that were accepted, those that hold from the next leg on included; null without
    /// one. Any thread.
    /// </summary>
    MissionPlan? Mission { get; }

    /// <summary>Gives a request that was made elsewhere.</summary>
    /// <param name="request">Not given before.</param>
    void Give(OperatorRequest request);
}
