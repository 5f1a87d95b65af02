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
    PushDropping,
}
