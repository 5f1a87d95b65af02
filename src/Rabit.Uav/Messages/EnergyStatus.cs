using System;

namespace Rabit.Uav.Messages;

/// <summary>
/// The energy of the flight: what is left in the battery and what the way home takes, both as fractions of the
/// battery's true capacity. A part of <see cref="MissionStatus"/>. A plain value.
/// </summary>
/// <example>
/// <code>
/// MessageSubscriber&lt;MissionStatus&gt; subscriber =
///     reactor.Workspace.Subscribe&lt;MissionStatus&gt;(MessageNames.Mission);
/// subscriber.Fetch();
/// EnergyStatus energy = subscriber.Value.Energy;
/// if (energy.IsKnown)
///     Console.WriteLine($"{energy.ChargeLeft:P0} left, home takes {energy.ChargeHome:P0}");
/// </code>
/// </example>
public struct EnergyStatus
{
    /// <summary>
    /// Whether charge and way home are known: where the battery is not reported, or home is not known, nothing of this
    /// is, and the fixed levels of <see cref="HealthMonitoring.HealthOptions"/> hold.
    /// </summary>
    public bool IsKnown { get; set; }

    /// <summary>What is truly left, 0 to 1; it may be less than the autopilot reports.</summary>
    public double ChargeLeft { get; set; }

    /// <summary>Standard deviation of <see cref="ChargeLeft"/>.</summary>
    public double ChargeLeftDeviation { get; set; }

    /// <summary>True capacity over the stated one: below 1 for an aged battery.</summary>
    public double CapacityFraction { get; set; }

    /// <summary>Standard deviation of <see cref="CapacityFraction"/>.</summary>
    public double CapacityFractionDeviation { get; set; }

    /// <summary>What the way home from here takes, with the landing; infinite against too strong a wind.</summary>
    public double ChargeHome { get; set; }

    /// <summary>Standard deviation of <see cref="ChargeHome"/>: of power and wind.</summary>
    public double ChargeHomeDeviation { get; set; }

    /// <summary>How long the way home takes, with the landing.</summary>
    public TimeSpan TimeHome { get; set; }

    /// <summary>What is to be left after the landing.</summary>
    public double Reserve { get; set; }

    /// <summary>
    /// How long it could hover here before it has to return; zero where it has to. Above zero while
    /// <see cref="IsKnown"/>.
    /// </summary>
    public TimeSpan TimeToReturn { get; set; }

    /// <summary>Power in hover, watts.</summary>
    public double HoverWatts { get; set; }

    /// <summary>Power at the ground speed of the mission without wind, watts.</summary>
    public double CruiseWatts { get; set; }

    /// <summary>What a climb adds, watts per metre per second.</summary>
    public double ClimbWattsPerMetrePerSecond { get; set; }

    /// <summary>Whether the wind is measured; otherwise one is assumed.</summary>
    public bool IsWindMeasured { get; set; }

    /// <summary>
    /// Whether it has to return: what is left is no more than the way home and the reserve, with the uncertainty of
    /// both.
    /// </summary>
    public bool MustReturn { get; set; }

    /// <summary>
    /// Whether home is out of reach and what is left is needed for the landing: it has to land where it is.
    /// </summary>
    public bool IsHomeOutOfReach { get; set; }

    /// <summary>What the whole plan takes, by the estimate before take-off; 0 where there was none.</summary>
    public double PlanCharge { get; set; }

    /// <summary>How long the whole plan takes, by that estimate.</summary>
    public TimeSpan PlanTime { get; set; }
}
