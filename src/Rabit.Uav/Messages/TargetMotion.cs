namespace Rabit.Uav.Messages;

/// <summary>How targets of a class move.</summary>
public enum TargetMotion
{
    /// <summary>They stay where they are.</summary>
    Standing = 0,

    /// <summary>As a person on foot, who may stop and go on.</summary>
    Walking = 1,

    /// <summary>As a vehicle: straight on, and turns, brakes and starts now and then.</summary>
    Vehicle = 2,
}
