// A game's loop: Bullet throws boxes about, SDL draws and plays them, libidiophone makes the sound.
// A click or a key throws them again.
//
//     boxes OBJECT.modal [SECONDS]
#include <SDL.h>
#include <btBulletDynamicsCommon.h>
#include <cstdio>
#include <cstdlib>
#include <idiophone.h>
#include <memory>
#include <vector>

constexpr int count = 12;
constexpr float stepSeconds = 1.0f / 240, wallMetres = 0.6f;

/// The audio thread.
void play(void* world, Uint8* bytes, int size) {
    auto* samples = reinterpret_cast<float*>(bytes);
    idiophone_world_render(static_cast<idiophone_world*>(world), samples, samples + 1,
                           static_cast<size_t>(size) / (2 * sizeof(float)), 2);
}

/// Says what has hit what in a step.
void report(btDispatcher& dispatcher, idiophone_world* world) {
    for (int m = 0; m < dispatcher.getNumManifolds(); ++m) {
        const auto* pair = dispatcher.getManifoldByIndexInternal(m);
        const int bodies[2] = {pair->getBody0()->getUserIndex(), pair->getBody1()->getUserIndex()};
        for (int p = 0; p < pair->getNumContacts(); ++p) {
            const auto& contact = pair->getContactPoint(p);
            if (contact.getLifeTime() > 1 || contact.m_appliedImpulse < 1e-4f)
                continue; // it rests there
            for (int side = 0; side < 2; ++side) {
                if (bodies[side] < 0) // a wall
                    continue;
                idiophone_impact hit = IDIOPHONE_IMPACT_DEFAULTS;
                hit.body = static_cast<size_t>(bodies[side]);
                hit.contact_time = 0.0004;
                for (int k = 0; k < 3; ++k) {
                    hit.point[k] = contact.getPositionWorldOnB()[k];
                    hit.impulse[k] = (side == 0 ? 1 : -1) * contact.m_appliedImpulse *
                                     contact.m_normalWorldOnB[k];
                }
                idiophone_world_strike(world, &hit);
            }
        }
    }
}

void draw(SDL_Renderer* picture, const btTransform& pose, const btVector3& half) {
    const auto corner = [&](int k) {
        const btVector3 at =
            pose * (half * btVector3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1));
        const float scale = 900 / (2 + at.y());
        return SDL_FPoint{400 + scale * at.x(), 500 - scale * at.z()};
    };
    for (int k = 0; k < 8; ++k)
        for (int other : {k | 1, k | 2, k | 4})
            SDL_RenderDrawLineF(picture, corner(k).x, corner(k).y, corner(other).x,
                                corner(other).y);
}

int main(int argumentCount, char** arguments) {
    auto* object = argumentCount < 2 ? nullptr : idiophone_object_load(arguments[1]);
    const std::vector<idiophone_body> made(count, {sizeof(idiophone_body), object, 1});
    auto* world = object == nullptr ? nullptr : idiophone_world_create(made.data(), count, nullptr);
    if (world == nullptr || SDL_Init(SDL_INIT_VIDEO | SDL_INIT_AUDIO) != 0) {
        std::fprintf(stderr, "boxes OBJECT.modal [SECONDS]\n%s\n", idiophone_error());
        return 1;
    }
    idiophone_world_set_gain(world, 0.5);
    const double lastSecond = argumentCount > 2 ? std::atof(arguments[2]) : 1e9;

    float low[3], high[3];
    idiophone_object_box(object, low, high);
    const btVector3 lowest(low[0], low[1], low[2]), highest(high[0], high[1], high[2]);
    const btVector3 half = (highest - lowest) / 2, middle = (highest + lowest) / 2;
    std::vector<std::unique_ptr<btRigidBody>> boxes, walls;
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld physics(&dispatcher, &broadphase, &solver, &configuration);
    physics.setGravity({0, 0, -9.81f});
    btStaticPlaneShape ground({0, 0, 1}, 0), left({1, 0, 0}, -wallMetres),
        right({-1, 0, 0}, -wallMetres), front({0, 1, 0}, -wallMetres),
        back({0, -1, 0}, -wallMetres);
    btBoxShape box(half);
    btVector3 inertia;
    const auto mass = static_cast<float>(idiophone_object_mass(object));
    box.calculateLocalInertia(mass, inertia);
    for (auto* plane : {&ground, &left, &right, &front, &back})
        walls.push_back(std::make_unique<btRigidBody>(0, nullptr, plane));
    for (int k = 0; k < count; ++k) {
        boxes.push_back(std::make_unique<btRigidBody>(mass, nullptr, &box, inertia));
        const btVector3 start(0.2f * float(k % 4) - 0.3f, 0.2f * float(k / 4) - 0.2f, 0.6f);
        boxes[k]->setWorldTransform(btTransform(btQuaternion({1, 2, 3}, float(k)), start));
        boxes[k]->setUserIndex(k);
        boxes[k]->setActivationState(DISABLE_DEACTIVATION);
    }
    for (auto* bodies : {&boxes, &walls})
        for (auto& body : *bodies) {
            body->setRestitution(0.6f);
            physics.addRigidBody(body.get());
        }

    SDL_Window* window = nullptr;
    SDL_Renderer* picture = nullptr;
    SDL_CreateWindowAndRenderer(800, 600, 0, &window, &picture);
    SDL_AudioSpec wanted{};
    wanted.freq = 48000;
    wanted.format = AUDIO_F32SYS;
    wanted.channels = 2;
    wanted.samples = 512;
    wanted.callback = play;
    wanted.userdata = world;
    const auto device = SDL_OpenAudioDevice(nullptr, 0, &wanted, nullptr, 0);
    SDL_PauseAudioDevice(device, 0);

    double seconds = 0;
    for (bool runs = true; runs && seconds < lastSecond; SDL_Delay(4)) {
        for (SDL_Event event; SDL_PollEvent(&event) != 0;) {
            runs = runs && event.type != SDL_QUIT;
            if (event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_KEYDOWN)
                for (auto& body : boxes)
                    body->setLinearVelocity({float(std::rand() % 5) - 2, 0, 4});
        }
        for (; seconds < SDL_GetTicks() / 1000.0; seconds += stepSeconds) {
            physics.stepSimulation(stepSeconds, 0);
            report(dispatcher, world);
        }
        SDL_SetRenderDrawColor(picture, 20, 20, 24, 255);
        SDL_RenderClear(picture);
        SDL_SetRenderDrawColor(picture, 230, 180, 90, 255);
        for (int k = 0; k < count; ++k) {
            const btTransform& pose = boxes[k]->getWorldTransform();
            const btVector3 origin = pose * -middle;
            const btQuaternion turn = pose.getRotation();
            const float rotation[4] = {turn.x(), turn.y(), turn.z(), turn.w()};
            idiophone_world_place(world, k, origin.m_floats, rotation);
            draw(picture, pose, half);
        }
        SDL_RenderPresent(picture);
    }
    SDL_CloseAudioDevice(device); // waits for the last callback
    idiophone_world_free(world);
    idiophone_object_free(object);
    SDL_Quit();
}
