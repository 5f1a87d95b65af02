using System;

namespace Rabit.Core.Tests.RealTimeKit;

/// <summary>A manager that asks for real time, and counts its warm-up runs.</summary>
internal sealed class RequestingManager : RabitManager
{
    private readonly Action? _inWarmUp;
    private readonly MessagePublisher<int> _message;

    public RequestingManager(string name, RealTimeRequest? request, Action? inWarmUp = null)
        : base(name)
    {
        _inWarmUp = inWarmUp;
        _message = Publish<int>(name + " message");
        if (request is not null)
            RequestRealTime(request);
    }

    public int WarmUps { get; private set; }

    public int WarmUpsAtStartup { get; private set; } = -1;

    public bool PostsInWarmUp { get; set; }

    public void RequestLater(RealTimeRequest request) => RequestRealTime(request);

    protected override void WarmUp()
    {
        WarmUps++;
        _inWarmUp?.Invoke();
        if (PostsInWarmUp)
            _message.Post();
    }

    protected override void Startup() => WarmUpsAtStartup = WarmUps;

    protected override void ExecuteUnitOfWork()
    {
    }
}
