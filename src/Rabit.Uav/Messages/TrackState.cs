namespace Rabit.Uav.Messages;

/// <summary>How sure a track is.</summary>
public enum TrackState
{
    /// <summary>Seen too rarely to be believed.</summary>
    Tentative,

    /// <summary>Believed.</summary>
    Confirmed,

    /// <summary>Was confirmed, and is not seen any more where it should be.</summary>
    Lost,
}
