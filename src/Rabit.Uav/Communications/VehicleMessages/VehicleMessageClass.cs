namespace Rabit.Uav.Communications;

/// <summary>How urgent a message between vehicles is. The first goes first.</summary>
public enum VehicleMessageClass
{
    /// <summary>An emergency.</summary>
    Urgent,

    /// <summary>What another vehicle is to do.</summary>
    Command,

    /// <summary>What vehicles agree on, each message of which counts.</summary>
    Coordination,

    /// <summary>
    /// State, of which the latest value counts: a newer message of the same type to the same destination replaces one
    /// that was not sent yet.
    /// </summary>
    State,

    /// <summary>What is large and can wait.</summary>
    Bulk,
}
