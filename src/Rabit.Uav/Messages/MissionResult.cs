namespace Rabit.Uav.Messages;

/// <summary>
/// The result of a mission, by what Mission Control knows: the phases, the fence, and the position that the autopilot
/// reports. While the mission is in progress it is what the result would be now. A plain value.
/// </summary>
public struct MissionResult
{
    /// <summary>A vehicle that landed within this distance from home has landed at home, metres.</summary>
    public const double MaxLandingDistanceMetres = 3;

    /// <summary>Whether the mission was accomplished.</summary>
    public MissionOutcome Outcome { get; set; }

    /// <summary>Why it is not accomplished; none where it is.</summary>
    public MissionFailures Failures { get; set; }

    /// <summary>Whether the vehicle took off.</summary>
    public bool HasFlown { get; set; }

    /// <summary>Whether the vehicle took off and landed: its motors are off, and did not stop in the air.</summary>
    public bool HasLanded { get; set; }

    /// <summary>
    /// Fraction of the area that the camera must have seen, 0 to 1; 0 where nothing is required: a mission without a
    /// camera.
    /// </summary>
    public double RequiredCoverage { get; set; }

    /// <summary>Horizontal distance from home; NaN where the plan or the position is not known.</summary>
    public double DistanceFromHomeMetres { get; set; }

    /// <summary>The largest horizontal distance that the vehicle was outside the fence; 0 where it never was.</summary>
    public double OutsideFenceMetres { get; set; }
}
