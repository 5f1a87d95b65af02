namespace Rabit.Uav.SensorFusion;

/// <summary>Why a report is not used, one of our own or of another vehicle.</summary>
public enum ReportFault
{
    /// <summary>It is used.</summary>
    None = 0,

    /// <summary>It names no vehicle, or its numbers of picture or target cannot be.</summary>
    Identity = 1,

    /// <summary>Its time lies in the future: the sender's clock, or its age, is wrong.</summary>
    Future = 2,

    /// <summary>It is older than the window of the tracks.</summary>
    TooOld = 3,

    /// <summary>Its position is none on the earth, or far away from all others.</summary>
    Position = 4,

    /// <summary>A covariance is none, or claims a millimetre or a kilometre.</summary>
    Covariance = 5,

    /// <summary>Its class, score or size is none.</summary>
    Description = 6,
}
