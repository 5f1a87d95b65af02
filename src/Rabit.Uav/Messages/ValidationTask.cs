using Rabit.Geodesy;

namespace Rabit.Uav.Messages;

/// <summary>
/// A target that its finder wants to be validated by another vehicle: the state of the task, which the finder repeats,
/// so that a message that is lost or comes twice changes nothing. A plain value.
/// </summary>
public struct ValidationTask
{
    /// <summary>MAVLink system id of the finder; not sent: it is that of the sender.</summary>
    public byte Finder { get; set; }

    /// <summary>The run of the finder: after a restart its numbers begin at 1 again.</summary>
    public ushort Session { get; set; }

    /// <summary>The number of the task, of its finder.</summary>
    public ushort Number { get; set; }

    /// <summary>How far it is.</summary>
    public ValidationState State { get; set; }

    /// <summary>The class of the target.</summary>
    public TargetClassName Class { get; set; }

    /// <summary>The id of the printed marker that it is; null for what is none.</summary>
    public int? MarkerId { get; set; }

    /// <summary>Where it is; the altitude is not used.</summary>
    public GeodeticPosition Position { get; set; }

    /// <summary>How uncertain that is: within so many metres with 95 %.</summary>
    public double RadiusMetres { get; set; }

    /// <summary>Grows with each award; 0 before the first.</summary>
    public ushort Award { get; set; }

    /// <summary>
    /// MAVLink system id of the vehicle that was awarded last; 0 for none; the finder's own where its operator has
    /// rejected the target.
    /// </summary>
    public byte Validator { get; set; }

    /// <summary>The result, once it is closed.</summary>
    public ValidationResult Result { get; set; }

    /// <summary>Whether the operator of its finder has rejected the target: no vehicle has to fly there.</summary>
    public readonly bool IsRejectedByOperator
        => State == ValidationState.Closed && Result == ValidationResult.Rejected && Finder != 0 && Validator == Finder;
}
