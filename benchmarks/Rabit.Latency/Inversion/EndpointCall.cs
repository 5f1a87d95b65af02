namespace Rabit.Latency.Inversion;

/// <summary>What a manager does with the message or queue that is measured.</summary>
internal enum EndpointCall
{
    /// <summary>Posts a struct that another manager posts too.</summary>
    PostShared,

    /// <summary>Posts a struct that no other manager posts.</summary>
    PostAlone,

    /// <summary>Fetches the struct of <see cref="PostAlone"/>.</summary>
    Fetch,

    /// <summary>Posts a class that copies itself.</summary>
    PostCopying,

    /// <summary>Pushes into a full queue whose oldest value makes room.</summary>
    PushDroppingOldest,

    /// <summary>Pushes into a full queue that drops what is pushed.</summary>
    PushDroppingNewest,

    /// <summary>Pushes into the queue of <see cref="PopOutside"/>, which rejects when it is full.</summary>
    PushRejecting,

    /// <summary>Pops through an endpoint of code outside managers, for which the queue has a lock.</summary>
    PopOutside,
}
